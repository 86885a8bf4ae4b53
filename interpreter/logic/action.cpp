// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/action.h"

#include <limits>

#include <fmt/format.h>

#include "interpreter/logic/machine.h"

namespace jaywalk {

namespace {

Outcome call_own(ActionCall& call) { return call.goal().action->own(call); }

// Jason's actions are classes: `.set.add` is the class `add`.
std::string_view class_name(const ActionDefinition& action) {
  return std::string_view(action.name).substr(action.name.rfind('.') + 1);
}

}  // namespace

std::string wrong_number_of_arguments(const ActionDefinition& action) {
  const int least = action.least_args;
  const int most = action.most_args < 0 ? std::numeric_limits<int>::max() : action.most_args;
  const std::string expected = least != most
                                   ? fmt::format("From {} to {} arguments are", least, most)
                               : least == 1 ? "One argument is"
                                            : fmt::format("{} arguments are", least);
  return fmt::format(
      "The internal action '{}' has not received the required number of argument(s). {} expected.",
      class_name(action), expected);
}

bool takes(const ActionDefinition& action, std::size_t count) {
  const auto number = static_cast<int>(count);
  const bool not_too_many =
      action.is_uncounted || action.most_args < 0 || number <= action.most_args;
  return number >= action.least_args && not_too_many;
}

ActionDefinition own_action(std::string name, int least_args, int most_args,
                            std::function<Outcome(ActionCall& call)> body) {
  ActionDefinition action;
  action.signature = name + "(...)";
  action.name = std::move(name);
  action.least_args = least_args;
  action.most_args = most_args;
  action.function = call_own;
  action.own = std::move(body);
  return action;
}

void ActionRegistry::add_all(const ActionRegistry& other) {
  for (const ActionDefinition& action : other.actions_) add(action);
  for (const FunctionDefinition& function : other.functions_) add(function);
}

void ActionRegistry::add(ActionDefinition action) {
  const ActionDefinition& stored = actions_.emplace_back(std::move(action));
  by_name_[stored.name] = &stored;
}

void ActionRegistry::add(FunctionDefinition function) {
  const FunctionDefinition& stored = functions_.emplace_back(std::move(function));
  functions_by_name_[stored.name] = &stored;
}

const ActionDefinition* ActionRegistry::action(std::string_view name) const {
  // Programs may call Jason's own by the full name of its class.
  constexpr std::string_view kPackage = "jason.stdlib";
  if (name.starts_with(kPackage) && name.substr(kPackage.size()).starts_with('.')) {
    name.remove_prefix(kPackage.size());
  }
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

const FunctionDefinition* ActionRegistry::function(std::string_view name, std::size_t arity) const {
  const auto found = functions_by_name_.find(name);
  if (found == functions_by_name_.end()) return nullptr;
  const FunctionDefinition& function = *found->second;
  const auto count = static_cast<int>(arity);
  return count >= function.least_args && count <= function.most_args ? &function : nullptr;
}

ActionCall::ActionCall(Machine& machine, const Goal& goal, Value* slots, Agent* agent,
                       Intention* intention)
    : machine_(machine),
      goal_(goal),
      slots_(slots),
      agent_(agent),
      intention_(intention),
      count_(goal.args().size()) {
  const bool raw = goal.action == nullptr || goal.action->raw_args;
  const std::span<const Value> terms = goal.args();
  if (count_ > few_args_.size()) many_args_.resize(count_);
  Value* const args = count_ > few_args_.size() ? many_args_.data() : few_args_.data();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const bool formula = i < goal.queries.size() && goal.queries[i] != nullptr;
    args[i] = raw || formula ? terms[i] : machine.unifier().instantiate(terms[i], slots);
  }
}

Value ActionCall::applied(std::size_t index) {
  return machine_.unifier().instantiate(args()[index], slots_);
}

bool ActionCall::unify(std::size_t index, Value value) {
  // Applied arguments have no slots; unification finds later bindings by itself.
  const bool raw = goal_.action == nullptr || goal_.action->raw_args;
  const Value own = args()[index];
  const Value variable = deref(own);
  if (variable.is_variable() && value.is_closed() && !Unifier::is_of_other_namespace(value)) {
    machine_.unifier().bind(variable.variable(), value);
    return true;
  }
  return machine_.unifier().unify(raw && !own.is_closed() ? applied(index) : own, value);
}

Outcome ActionCall::fail(std::string id, std::string message) {
  error().id = std::move(id);
  error().message = std::move(message);
  return Outcome::error;
}

Outcome ActionCall::java_exception(std::string message) {
  error().annots.push_back(
      heap().structure(predicates::error_msg, std::array<Value, 1>{heap().text("")}));
  return fail("unknown", std::move(message));
}

Outcome ActionCall::wrong_arguments(std::string_view reason) {
  return fail("wrong_arguments",
              fmt::format("Wrong argument for internal action '{}': {}",
                          goal_.action == nullptr ? "" : class_name(*goal_.action), reason));
}

Outcome ActionCall::wrong_argument(std::size_t index, std::string_view expected) {
  constexpr std::array<std::string_view, 5> kPlaces{"first", "second", "third", "fourth", "fifth"};
  const std::string_view place = index < kPlaces.size() ? kPlaces.at(index) : "an";
  return wrong_arguments(fmt::format("{} argument must be {}", place, expected));
}

void ActionCall::solve(std::size_t index, const std::function<bool()>& solution) {
  if (is_compiled(index)) {
    machine_.solve_all(goal_.queries[index], slots_, solution);
  } else {
    machine_.solve_all_terms(arg(index), solution);
  }
}

std::size_t ActionCall::count_answers(std::size_t index) {
  if (is_compiled(index)) return machine_.count_all(goal_.queries[index], slots_);
  std::size_t number = 0;
  machine_.solve_all_terms(arg(index), [&] {
    ++number;
    return true;
  });
  return number;
}

Heap& ActionCall::heap() { return machine_.heap(); }
SymbolTable& ActionCall::symbols() { return machine_.symbols(); }
Unifier& ActionCall::unifier() { return machine_.unifier(); }

}  // namespace jaywalk
