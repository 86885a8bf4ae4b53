#pragma once

// Failures of agents and tests, as text.

#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/comparison.h"

namespace jaywalk {

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
