// SPDX-License-Identifier: Apache-2.0
// The machine's calls of C++ code: internal actions, in queries and in plan bodies, and arithmetic
// functions.

#include <fmt/format.h>

#include "interpreter/logic/machine.h"
#include "interpreter/term/compare.h"

namespace jaywalk {

bool Machine::action(const Goal& goal) {
  if (goal.action == nullptr) {
    warn(fmt::format("there is no internal action {}", symbols_.functor(goal.predicate)));
    return false;
  }
  if (goal.action->body_only) {
    warn(fmt::format("{} cannot be used within a formula", goal.action->name));
    return false;
  }
  ActionCall call(*this, goal, environment_->slots, agent_, nullptr);
  if (!takes(*goal.action, call.count())) {
    warn(fmt::format("wrong number of arguments: {}", goal.action->signature));
    return false;
  }
  switch (goal.action->function(call)) {
    case Outcome::succeeded:
      goal_ = goal.next;
      return true;
    case Outcome::failed:
      return false;
    case Outcome::many:
      push(ChoicePoint::Kind::solutions, goal).call = std::make_unique<ActionCall>(std::move(call));
      return next_solution();
    case Outcome::suspended:
      return false;
    case Outcome::error:
      warn(fmt::format("{}: {}", goal.action->name, call.error().message));
      return false;
  }
  return false;
}

bool Machine::next_solution() {
  ChoicePoint& choice = choices_.back();
  const Goal& goal = *choice.goal;
  // The action may run queries of its own, which use the stack above this choice point.
  std::unique_ptr<ActionCall> call = std::move(choice.call);
  const bool found = call->solutions->next(*call);
  choices_.back().call = std::move(call);
  if (!found) {
    pop();
    return false;
  }
  goal_ = goal.next;
  return true;
}

const CountedNumbers* Machine::numbers_left(const Goal& entry) const {
  const bool is_waiting = entry.next == nullptr && !choices_.empty() &&
                          choices_.back().kind == ChoicePoint::Kind::solutions &&
                          choices_.back().goal == &entry;
  return is_waiting ? choices_.back().call->solutions->numbers() : nullptr;
}

Outcome Machine::call(const Goal& goal, Value* slots, Intention* intention,
                      std::unique_ptr<ActionError>& error) {
  const auto give_up = [&error](std::string id, std::string message) {
    error = std::make_unique<ActionError>();
    error->id = std::move(id);
    error->message = std::move(message);
    return Outcome::error;
  };
  if (goal.action == nullptr) {
    return give_up("unknown_internal_action",
                   fmt::format("there is no internal action {}", symbols_.functor(goal.predicate)));
  }
  ActionCall call(*this, goal, slots, agent_, intention);
  Outcome outcome = Outcome::error;
  if (takes(*goal.action, call.count())) {
    outcome = goal.action->function(call);
  } else if (goal.action->is_uncounted) {
    outcome = call.java_exception(wrong_number_of_arguments(*goal.action));
  } else {
    outcome = call.fail("wrong_arguments", wrong_number_of_arguments(*goal.action));
  }
  if (outcome == Outcome::many) {
    outcome = call.solutions->next(call) ? Outcome::succeeded : Outcome::failed;
  }
  if (outcome == Outcome::error) error = std::make_unique<ActionError>(std::move(call.error()));
  return outcome;
}

bool Machine::call_function(const Structure& function, Value& result) {
  const Signature& signature = symbols_.signature(function.predicate());
  for (const RuleFunction& known : *functions_) {
    if (known.name != signature.functor || known.arity != function.arity) continue;
    std::vector<Value> args(function.arg_span().begin(), function.arg_span().end());
    const Value answer = heap().variable();
    args.push_back(answer);
    const Value query = heap().structure(known.predicate, args);
    const std::size_t trail = unifier_.mark();
    if (!solve_term(query)) return false;
    result = unifier_.apply(answer);
    unifier_.undo(trail);
    return true;
  }
  const FunctionDefinition* const definition =
      actions_->function(symbols_.text(signature.functor), function.arity);
  if (definition == nullptr) return false;
  if (definition->function != nullptr || definition->own) {
    for (const Value arg : function.arg_span()) {
      if (!is_ground(arg)) return false;
    }
    return definition->own ? definition->own(function.arg_span(), heap(), symbols_, result)
                           : definition->function(function.arg_span(), heap(), symbols_, result);
  }
  if (definition->name == ".count") {
    double count = 0;
    solve_all_terms(function.arg(0), [&] {
      ++count;
      return true;
    });
    result = Value::number(count);
    return true;
  }
  if (definition->name == "system.time") {
    if (surroundings_ == nullptr) return false;
    result = Value::number(surroundings_->clock_ms());
    return true;
  }
  if (surroundings_ == nullptr) return false;  // math.random([N])
  double most = 1;
  if (function.arity == 1 && !unifier_.evaluate(function.arg(0), nullptr, most)) return false;
  result = Value::number(surroundings_->draw() * most);
  return true;
}

// Functions that the agent has defined by rules come first, so they must be none.
bool Machine::call_of_numbers(Predicate function, std::span<const Value> args, Value& result) {
  if (!functions_->empty()) return false;
  KnownFunction& known =
      known_functions_[static_cast<std::size_t>(function) % known_functions_.size()];
  if (known.definition == nullptr || known.predicate != function) {
    known = {function, actions_->function(symbols_.functor(function), args.size())};
  }
  return known.definition != nullptr && known.definition->function != nullptr &&
         known.definition->function(args, heap(), symbols_, result);
}

void Machine::warn(std::string_view message) {
  if (surroundings_ != nullptr) {
    surroundings_->log(message);
  } else if (log_) {
    log_(message);
  }
}

}  // namespace jaywalk
