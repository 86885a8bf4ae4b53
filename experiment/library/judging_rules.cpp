// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "experiment/compare/test_assessment.h"
#include <jaywalk/judge.h>

namespace jaywalk {

JudgingRules::JudgingRules() : criteria_(std::make_shared<const Criteria>()) {}
JudgingRules::JudgingRules(std::shared_ptr<const Criteria> criteria)
    : criteria_(std::move(criteria)) {}

Result<JudgingRules> JudgingRules::read(const std::vector<std::string>& paths) {
  auto files = read_assertion_files(paths);
  if (!files) return std::move(files.diagnostics());
  Criteria criteria;
  criteria.assertions = std::move(files.value().assertions);
  criteria.files = std::move(files.value().sources);
  return JudgingRules(std::make_shared<const Criteria>(std::move(criteria)));
}

JudgingRules JudgingRules::with_metrics(bool measured) const {
  Criteria criteria = *criteria_;
  criteria.metrics = measured;
  return JudgingRules(std::make_shared<const Criteria>(std::move(criteria)));
}

std::vector<AssertionInfo> JudgingRules::assertions() const {
  std::vector<AssertionInfo> all;
  for (const Assertion& assertion : criteria_->assertions) {
    all.push_back({.id = assertion.id,
                   .summary = assertion.summary,
                   .source = assertion.source,
                   .severity = assertion.severity});
  }
  return all;
}

}  // namespace jaywalk
