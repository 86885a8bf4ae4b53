// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rules whose answers do not change during a run, since they ask nothing but constant percepts and
// facts that the program begins with (program/rule_folder.h finds them):
//
//   av_lane(First, Last) :- av_rows(Row, _) & lane(First, Last, _) & First <= Row & Row <= Last.
//
// has the one answer av_lane(2, 5) on every road with its lanes there. A query that leaves all
// arguments open takes the answers, and the rules are not asked, as long as the agent has changed
// nothing that they ask; after that they are asked as ever (BeliefBase::fold). The inferences that
// asking them would take are counted, so that limits are met in the same places.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/logic/beliefs/rule_table.h"
#include "interpreter/logic/beliefs/shared_rows.h"

namespace jaywalk {

/// The answers of rules, in the order in which these find them.
struct Answers {
  std::size_t arity = 0;
  /// Numbers and atoms: the arguments of the first answer, then those of the second, and so on.
  std::vector<Value> values;
  /// The inferences that the rules take to find each answer, and, as the last entry, to find that
  /// there is no other: 0 if the last answer leaves no choice point. The query's own inference is
  /// not counted.
  std::vector<std::uint64_t> inferences;

  [[nodiscard]] std::size_t size() const { return inferences.size() - 1; }
  [[nodiscard]] std::span<const Value> answer(std::size_t index) const {
    return std::span(values).subspan(index * arity, arity);
  }
  /// Whether a query that has got this answer may go back for another.
  [[nodiscard]] bool may_go_on_after(std::size_t index) const {
    return index < size() && inferences[index + 1] > 0;
  }
};

struct FoldedRules {
  /// Rows that the rules ask.
  struct Need {
    Predicate predicate{};
    const SharedRows* rows = nullptr;
  };

  /// `rules` and the rows in `needed` outlive it.
  FoldedRules(Predicate of, const RuleTable& rules, std::vector<Need> needed, Answers found)
      : predicate(of), needs(std::move(needed)), answers(std::move(found)), table(rules, answers) {}
  FoldedRules(const FoldedRules&) = delete;
  FoldedRules& operator=(const FoldedRules&) = delete;

  Predicate predicate{};
  /// The rows that the answers depend on, the rules' own rows included.
  std::vector<Need> needs;
  Answers answers;
  RuleTable table;
};

}  // namespace jaywalk
