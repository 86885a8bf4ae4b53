// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/comparison.h"

#include <algorithm>

namespace jaywalk {

void add_assessments(const Criteria& criteria, const AssessmentTable& assessments,
                     const std::vector<std::string>& behaviours, Comparison& comparison) {
  comparison.assertions.clear();
  comparison.assessments.clear();
  if (!asks(criteria)) return;
  comparison.assertions = ids_of(criteria);
  for (const Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(behaviours, summary.behaviour) - behaviours.begin();
    comparison.assessments.push_back(
        assessments.summary(static_cast<std::size_t>(behaviour), summary.agents));
  }
}

}  // namespace jaywalk
