// SPDX-License-Identifier: Apache-2.0
#pragma once

// A comparison as tables for a terminal of 80 columns.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/avs/av_ranking.h"
#include "experiment/compare/comparison.h"

namespace jaywalk {

/// A row for each assertion, behaviour and number of agents; empty if none was judged.
[[nodiscard]] std::string render_verdicts(const Comparison& comparison);
/// How each metric is spread; empty if none was measured.
[[nodiscard]] std::string render_metrics(const Comparison& comparison);
/// All tables of the comparison as far as there are any.
[[nodiscard]] std::string render_tables(const Comparison& comparison);
/// The text for one test: a line for each assertion, and one for each metric that has a value.
[[nodiscard]] std::string render_assessment(const Criteria& criteria,
                                            const TestAssessment& assessment,
                                            std::span<const Actor> actors);

/// Measures, our values next to the published ones: a block of lines for each behaviour; empty if
/// nothing is finished.
[[nodiscard]] std::string render_table(const Comparison& comparison);

/// How models of the AV rank, then each behaviour with each model; empty if no models were
/// compared.
[[nodiscard]] std::string render_avs(const AvRanking& ranking);

/// The kills of each behaviour, and the killers of each defect; empty if no defects were looked
/// for.
[[nodiscard]] std::string render_kills(const Comparison& comparison);
/// The kills alone, without the lines that need other measures of the comparison.
[[nodiscard]] std::string render_kills(const KillMatrix& matrix);

/// The failures of one behaviour, all numbers of agents together.
struct BehaviourTroubles {
  std::string behaviour;
  Troubles troubles;
};
/// In the order of the comparison; behaviours without trouble are left out.
[[nodiscard]] std::vector<BehaviourTroubles> troubles_of(const Comparison& comparison);

/// Sentences about a behaviour's failures, without their causes: "15 of 15 agents dropped an
/// intention", "its 15 agents never acted".
[[nodiscard]] std::vector<std::string> trouble_sentences(const Troubles& troubles);

/// A few lines for each behaviour: how many of its agents dropped intentions, and why; empty if all
/// is well.
[[nodiscard]] std::string render_troubles(const std::vector<BehaviourTroubles>& behaviours);

/// How many of the comparison's tests ended errored.
[[nodiscard]] std::uint64_t errored_tests(const Comparison& comparison);

/// Whether `--strict` objects: some agent has dropped an intention, a test ended errored, or a
/// behaviour never acted.
[[nodiscard]] bool is_troubled(const std::vector<BehaviourTroubles>& behaviours);

}  // namespace jaywalk
