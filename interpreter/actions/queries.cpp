// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/support/grown_bytes.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

std::vector<Value> collect(ActionCall& call) {
  std::vector<Value> found;
  call.solve(1, [&] {
    found.push_back(call.unifier().fresh_copy(call.applied(0)));
    constexpr std::size_t kBetweenChecks = 1024;
    if (found.size() % kBetweenChecks == 0) {
      // Beside the results there will be the list of them.
      call.machine().check_memory(grown_bytes(found.size(), sizeof(Value)) +
                                  2 * found.size() * sizeof(Pair));
    }
    return true;
  });
  return found;
}

}  // namespace

Outcome findall(ActionCall& call) {
  if (!is_java_literal(deref(call.applied(1)))) return call.wrong_argument(1, "a formula");
  const std::vector<Value> found = collect(call);
  return call.result(2, call.heap().list(found));
}

Outcome setof(ActionCall& call) {
  if (!is_java_literal(deref(call.applied(1)))) return call.wrong_argument(1, "a formula");
  std::vector<Value> found = collect(call);
  sort_as_set(found, call);
  return call.result(2, call.heap().list(found));
}

Outcome count(ActionCall& call) {
  const auto number = static_cast<double>(call.count_answers(0));
  return call.count() == 1 ? Outcome::succeeded : call.result(1, Value::number(number));
}

Outcome eval(ActionCall& call) {
  if (!is_java_literal(deref(call.applied(1)))) {
    return call.wrong_argument(1, "a logical formula");
  }
  bool holds = false;
  call.solve(1, [&] {
    holds = true;
    return false;
  });
  return call.result(0, Value::atom(holds ? predicates::truth : predicates::falsity));
}

}  // namespace jaywalk::actions
