// SPDX-License-Identifier: Apache-2.0
// Rule ExecInt for `for`. The condition is solved as the rounds need solutions: each conjunct is a
// level with all solutions of it together with the conjuncts before. So later conjuncts of later
// rounds see a round's changes of belief, as in Jason. A conjunct that might have endlessly many
// solutions is asked for a few at a time; when it is asked again for more, solutions that have had
// their round are left out.

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "interpreter/agent/agent.h"
#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

// Whether a formula might have solutions without end: it depends on rules that are recursive, or on
// `.random`, which draws as often as it is asked.
class EndlessSearch {
 public:
  EndlessSearch(BeliefBase& beliefs, const SymbolTable& symbols)
      : beliefs_(beliefs), symbols_(symbols) {}

  bool is_found(const Goal* goal) {
    for (; goal != nullptr && seen_.insert(goal).second; goal = goal->next) {
      if (is_found(goal->inner) || is_found(goal->other)) return true;
      if (goal->kind == Goal::Kind::variable) return true;
      if (goal->kind == Goal::Kind::action && symbols_.functor(goal->predicate) == ".random") {
        return true;
      }
      const bool asks = goal->kind == Goal::Kind::query || goal->kind == Goal::Kind::slow_query;
      if (asks && is_recursive(goal->predicate)) return true;
    }
    return false;
  }

 private:
  bool is_recursive(Predicate predicate) {
    const auto [known, is_new] = is_open_.emplace(predicate, true);
    if (!is_new) return known->second;
    const Relation* const relation = beliefs_.find(predicate);
    if (relation != nullptr && relation->has_rules()) {
      for (std::int64_t seq = relation->first_seq(); seq < relation->end_seq(); ++seq) {
        const RuleCode* const rule = relation->row(seq).rule;
        if (rule != nullptr && is_found(rule->body.entry)) return true;
      }
    }
    is_open_[predicate] = false;
    return false;
  }

  BeliefBase& beliefs_;
  const SymbolTable& symbols_;
  std::unordered_set<const Goal*> seen_;
  std::unordered_map<Predicate, bool> is_open_;  // true: its rules are being looked at
};

constexpr std::size_t kFirstSolutions = 32;

using Level = Loop::Level;

std::span<const Value> solution(const Level& level, std::size_t index) {
  const std::size_t begin = index == 0 ? 0 : level.ends[index - 1];
  return std::span(level.solutions).subspan(begin, level.ends[index] - begin);
}

// Open values are renamed whenever they are asked for, and count as the same.
bool are_same(std::span<const Value> a, std::span<const Value> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](Value x, Value y) {
    if (x.is_slot() || y.is_slot() || !x.is_closed() || !y.is_closed()) {
      return x.is_slot() == y.is_slot() && (!x.is_slot() || x.same_as(y));
    }
    return equal_terms(x, y);
  });
}

// Leaves out of `again` what `before` has, once for each time that it is there.
void remove_known(const Level& before, Level& again) {
  std::vector<bool> met(before.ends.size());
  std::size_t expected = 0;
  Level fresh;
  for (std::size_t i = 0; i < again.ends.size(); ++i) {
    const std::span<const Value> found = solution(again, i);
    const auto is_it = [&](std::size_t k) {
      return !met[k] && are_same(solution(before, k), found);
    };
    std::size_t k = expected;
    if (k >= met.size() || !is_it(k)) {
      for (k = 0; k < met.size() && !is_it(k);) ++k;
    }
    if (k < met.size()) {
      met[k] = true;
      expected = k + 1;
      continue;
    }
    fresh.solutions.insert(fresh.solutions.end(), found.begin(), found.end());
    fresh.ends.push_back(fresh.solutions.size());
  }
  again.solutions = std::move(fresh.solutions);
  again.ends = std::move(fresh.ends);
}

}  // namespace

// At most `most` solutions of a conjunct, each with the bindings of the levels before.
Loop::Level Agent::collect_solutions(Intention& intention, const Goal* condition,
                                     std::span<const Value> before, std::size_t most) {
  Level level;
  Unifier& unifier = machine().unifier();
  const IntendedMeans& means = intention.top();
  Value* const first = intention.frame(means);
  Value* const last = first + means.plan->slot_count;
  const std::size_t trail = unifier.mark();
  const std::uint32_t young = heap_.first_young();
  machine().solve_all(condition, first, [&] {
    if (level.ends.size() == most) {
      level.has_more = true;
      return false;
    }
    level.solutions.insert(level.solutions.end(), before.begin(), before.end());
    // A formula from run-time data may have bound a variable to a term with slots of this frame;
    // giving those a variable is a binding, too, behind the ones that are looked at here.
    const std::size_t count = unifier.bindings_since(trail).size();
    for (std::size_t i = 0; i < count; ++i) {
      Value* const cell = unifier.bindings_since(trail)[i];
      const bool is_slot = cell >= first && cell < last;
      if (!is_slot && !machine().is_known_outside(cell, young)) continue;
      level.solutions.push_back(is_slot ? Value::slot(static_cast<std::uint32_t>(cell - first))
                                        : Value::reference(Value::Kind::variable, cell, 0));
      const Value held = deref(*cell);
      level.solutions.push_back(held.is_closed() ? held : unifier.instantiate(held, first));
    }
    level.ends.push_back(level.solutions.size());
    if (const CountedNumbers* const numbers = machine().numbers_left(*condition);
        numbers != nullptr && level.solutions.size() == before.size() + 2) {
      level.numbers = *numbers;
      return false;
    }
    constexpr std::size_t kBetweenChecks = 1024;
    if (level.ends.size() % kBetweenChecks == 0) machine().check_memory(bytes_of(level));
    return true;
  });
  heap_.note_other_bytes(bytes_of(level));
  return level;
}

void Agent::bind_solution(Intention& intention, Loop& loop, std::span<const Value> pairs) {
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    bind_recorded(intention, loop, pairs[i], pairs[i + 1]);
  }
}

// Goes one conjunct further. What satisfies those before is bound.
void Agent::open_level(Intention& intention, Loop& loop) {
  const Goal* const condition = loop.step->conjuncts[loop.levels.size()];
  std::span<const Value> before;
  if (!loop.levels.empty()) {
    before = solution(loop.levels.back(), loop.levels.back().next - 1);
  }
  const bool may_be_endless = EndlessSearch(beliefs_, symbols_).is_found(condition);
  Level level = collect_solutions(intention, condition, before,
                                  may_be_endless ? kFirstSolutions : std::size_t(-1));
  loop.levels.push_back(std::move(level));
}

// Asks the last level's conjunct again, for twice as many solutions.
void Agent::extend_level(Intention& intention, Loop& loop) {
  const std::size_t index = loop.levels.size() - 1;
  std::vector<Value> before;
  if (index > 0) {
    const Level& outer = loop.levels[index - 1];
    const std::span<const Value> bound = solution(outer, outer.next - 1);
    before.assign(bound.begin(), bound.end());
    bind_solution(intention, loop, before);
  }
  Level& level = loop.levels.back();
  Level again = collect_solutions(intention, loop.step->conjuncts[index], before,
                                  2 * std::max(level.ends.size(), kFirstSolutions));
  undo_round(intention, loop);
  level.has_more = again.has_more;
  remove_known(level, again);
  for (const std::size_t end : again.ends) level.ends.push_back(level.solutions.size() + end);
  level.solutions.insert(level.solutions.end(), again.solutions.begin(), again.solutions.end());
}

// Restores the bindings of the next round. False: there is no other round.
bool Agent::begin_round(Intention& intention, Loop& loop) {
  while (!loop.levels.empty()) {
    undo_round(intention, loop);
    Level& level = loop.levels.back();
    if (!level.advance()) {
      if (level.has_more) {
        extend_level(intention, loop);
      } else {
        loop.levels.pop_back();
      }
      continue;
    }
    bind_solution(intention, loop, solution(level, level.next - 1));
    if (loop.levels.size() == loop.step->conjuncts.size()) return true;
    open_level(intention, loop);
  }
  return false;
}

void Agent::execute_for(Intention& intention, const Step& step) {
  IntendedMeans& means = intention.top();
  std::vector<Loop>& loops = means.extras.make().loops;
  if (loops.empty() || loops.back().step != &step) {
    heap_.require_room();
    loops.emplace_back().step = &step;
    open_level(intention, loops.back());
  }
  if (!begin_round(intention, loops.back())) {
    loops.pop_back();
    go_on(intention);
    return;
  }
  intention.go_on_at(step.first->begin(&step));
  make_ready(intention);
}

}  // namespace jaywalk
