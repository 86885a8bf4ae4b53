// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which rules of a relation may match a query. Where a predicate is defined by a few rules alone,
// as most are, the kind of the first argument mostly leaves one of them:
//
//   append([], L, L).                  empty list  → the first
//   append([H|T], L, [H|R]) :- …       list        → the second
//                                      variable    → several: they are looked at one by one
//
// So a query needs one look into a table by the kind of its first argument, and no choice point. A
// table does not change; that of a program's rules is shared by all agents that run it. Where the
// answers of the rules are known (folded_rules.h) an agent has another table, which names them.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "interpreter/logic/code/code.h"

namespace jaywalk {

struct Answers;

class RuleTable {
 public:
  /// A rule, as a query sees it at first: key of the first argument (argument_key of belief_base.h;
  /// 0: any), and whether others have to be looked at.
  struct Candidate {
    std::uint32_t key = 0;
    bool has_tests = false;
    const RuleCode* rule = nullptr;

    [[nodiscard]] bool may_match(std::uint32_t wanted, const Value* args) const {
      return (key == wanted || key == 0 || wanted == 0) &&
             (!has_tests || !rule->head_code.rejects(args));
    }
  };
  /// More rules than these are found by an index.
  static constexpr std::size_t kMostRules = 8;

  RuleTable() = default;
  /// In the order in which they are asked. REQUIRES: heads of one predicate, at least one.
  explicit RuleTable(std::vector<Candidate> candidates);
  /// The same rules with their answers, which outlive it.
  RuleTable(const RuleTable& rules, const Answers& answers) : RuleTable(rules) {
    answers_ = &answers;
  }

  [[nodiscard]] std::span<const Candidate> candidates() const { return candidates_; }
  /// The only rule that may match a first argument of this kind (any kind, if there are no
  /// arguments); null: there is none, or several.
  [[nodiscard]] const RuleCode* only(Value first_argument) const {
    return only_[static_cast<std::size_t>(first_argument.kind())];
  }
  /// Null: they have to be asked.
  [[nodiscard]] const Answers* answers() const { return answers_; }

 private:
  static constexpr std::size_t kKinds = 8;

  std::vector<Candidate> candidates_;
  std::array<const RuleCode*, kKinds> only_{};
  const Answers* answers_ = nullptr;
};

}  // namespace jaywalk
