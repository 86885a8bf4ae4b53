// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/actions.h"
#include "interpreter/actions/java/java_text.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::actions {

// N draws by going back, or with 0 draws without end.
Outcome random(ActionCall& call) {
  if (call.agent() == nullptr) return Outcome::failed;
  const bool from_list = call.arg(0).is_list();
  const std::size_t result = from_list ? 1 : 0;
  if (call.count() <= result) return call.java_exception(".random needs a variable");
  if (!call.arg(result).is_variable()) return call.wrong_argument(result, "a variable.");
  std::int32_t count = 1;
  if (call.count() > result + 1) {
    if (!call.arg(result + 1).is_number()) return call.wrong_argument(result + 1, "a number.");
    count = java_int(call.arg(result + 1).as_number());
  }
  std::vector<Value> from = elements(call.arg(0));
  if (from_list && from.empty()) return Outcome::failed;
  return each(call, [from = std::move(from), result, endless = count == 0,
                     left = count](ActionCall& inner) mutable {
    if (!endless && left-- <= 0) return false;
    JavaRandom& random = inner.agent()->random();
    if (from.empty()) return inner.unify(result, Value::number(random.next_double()));
    const std::int32_t drawn = random.next_int(static_cast<std::int32_t>(from.size()));
    return inner.unify(result, from[static_cast<std::size_t>(drawn)]);
  });
}

Outcome set_random_seed(ActionCall& call) {
  if (!call.arg(0).is_number()) return call.java_exception("the first argument is no number");
  if (call.agent() == nullptr) return Outcome::failed;
  const double seed = call.arg(0).as_number();
  // Java's narrowing to a long.
  constexpr double kLimit = 9223372036854775808.0;
  const std::int64_t word = !(seed == seed)   ? 0
                            : seed >= kLimit  ? INT64_MAX
                            : seed <= -kLimit ? INT64_MIN
                                              : static_cast<std::int64_t>(seed);
  call.agent()->random().set_seed(word);
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions
