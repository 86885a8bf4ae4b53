#pragma once

// Rules whose answers do not change during a run, since they are of nothing but constant percepts
// and what a program begins with (program/rule_folder.h finds them):
//
//   av_lane(First, Last) :- av_rows(Row, _) & lane(First, Last, _) & First <= Row & Row <= Last.
//
// has the one answer av_lane(2, 5) on every road with its lanes there. A query for all answers gets
// these, as long as the agent believes of all that the rules are of what it shares with the other
// agents; then it asks the rules (BeliefBase::fold). Nobody can tell that they are not asked: the
// inferences that asking them takes count, so that limits are met in the same places, and so do the
// variables that are made for it, whose numbers can be printed.

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
  /// Numbers and atoms, an answer's after the other's.
  std::vector<Value> values;
  /// Without those of the query itself.
  struct Effort {
    std::uint64_t inferences = 0;
    std::uint64_t variables = 0;
  };
  /// Until the first answer, from each to the next, and until there is no more; no inferences where
  /// that is known with the last answer, and otherwise at least one to go back.
  std::vector<Effort> efforts;

  [[nodiscard]] std::size_t size() const { return efforts.size() - 1; }
  [[nodiscard]] std::span<const Value> answer(std::size_t index) const {
    return std::span(values).subspan(index * arity, arity);
  }
  /// Whether a query that has got this answer may go back for another.
  [[nodiscard]] bool may_go_on_after(std::size_t index) const {
    return index < size() && efforts[index + 1].inferences > 0;
  }
};

struct FoldedRules {
  /// Rows that the answers are of.
  struct Need {
    Predicate predicate{};
    const SharedRows* rows = nullptr;
  };

  /// `rules` and what is needed outlive it.
  FoldedRules(Predicate of, const RuleTable& rules, std::vector<Need> needed, Answers found)
      : predicate(of), needs(std::move(needed)), answers(std::move(found)), table(rules, answers) {}
  FoldedRules(const FoldedRules&) = delete;
  FoldedRules& operator=(const FoldedRules&) = delete;

  Predicate predicate{};
  /// Those of the rules themselves included.
  std::vector<Need> needs;
  Answers answers;
  RuleTable table;
};

}  // namespace jaywalk
