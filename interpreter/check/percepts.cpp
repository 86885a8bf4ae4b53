// SPDX-License-Identifier: Apache-2.0
// Percepts that agents never have in the scenario of their program.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/check/checking.h"

namespace jaywalk {
namespace {

using ast::Node;

// Whether it stands in a rule of a library that the program does not use.
bool is_in_unused_rule(const Checking& checking, const CheckedFile& file, const Node& query) {
  return !file.is_main && std::ranges::any_of(file.uses.clauses, [&](const Clause& clause) {
    return clause.body != nullptr && clause.body->span.begin <= query.span.begin &&
           query.span.end <= clause.body->span.end && !checking.is_mentioned(clause.head->text);
  });
}

// Looks at literals that a percept would answer, and warns of each absent percept once.
class AbsentPercepts {
 public:
  explicit AbsentPercepts(Checking& checking) : checking_(checking) {}

  void look_at(CheckedFile& file, const Node& literal) {
    if (literal.kind != ast::Kind::literal) return;
    const Vocabulary::Entry* const percept =
        entry_of(checking_.vocabulary().percepts, literal.text);
    if (percept == nullptr || percept->absent_without.empty()) return;
    if (!takes(*percept, arity_of(literal)) || comes_from_elsewhere(*percept)) return;
    if (is_in_unused_rule(checking_, file, literal) || told_.contains(literal.text)) return;
    const std::size_t before = file.found.warning_count();
    checking_.warn(file, literal.span,
                   fmt::format("the scenario does not give the percept '{}'", literal.text),
                   fmt::format("it needs {}", percept->absent_without));
    if (file.found.warning_count() > before) told_.insert(literal.text);
  }

 private:
  [[nodiscard]] bool comes_from_elsewhere(const Vocabulary::Entry& percept) const {
    return checking_.index().given.contains(percept.name, percept.least_args) ||
           checking_.index().planned_tests.contains(percept.name, percept.least_args) ||
           checking_.vocabulary().named_by_others.contains(percept.name);
  }

  Checking& checking_;
  std::set<std::string_view> told_;
};

}  // namespace

void absent_percepts(Checking& checking) {
  if (checking.index().has_open_beliefs) return;
  AbsentPercepts absent(checking);
  for (CheckedFile& file : checking.files()) {
    for (const Node* query : file.uses.queries) absent.look_at(file, *query);
    for (const ast::Plan* plan : file.uses.plans) {
      if (plan->trigger.kind == ast::TriggerKind::belief) {
        absent.look_at(file, *plan->trigger.literal);
      }
    }
  }
}

}  // namespace jaywalk
