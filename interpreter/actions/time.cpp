#include <array>
#include <chrono>
#include <cmath>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::actions {
namespace {

std::chrono::sys_time<std::chrono::milliseconds> now(ActionCall& call) {
  const double ms = call.agent() == nullptr ? 0 : call.agent()->host().now_ms();
  return std::chrono::sys_time<std::chrono::milliseconds>(
      std::chrono::milliseconds(static_cast<std::int64_t>(kEpochMs + std::floor(ms))));
}

template <std::size_t N>
Outcome unify_all(ActionCall& call, const std::array<double, N>& numbers) {
  for (std::size_t i = 0; i < call.count(); ++i) {
    if (!call.arg(i).is_number() && !call.arg(i).is_variable()) {
      return call.wrong_argument(i, "a number or a variable");
    }
    if (!call.unify(i, Value::number(numbers[i]))) return Outcome::failed;
  }
  return Outcome::succeeded;
}

}  // namespace

Outcome time(ActionCall& call) {
  const auto moment = now(call);
  const std::chrono::hh_mm_ss clock(moment - std::chrono::floor<std::chrono::days>(moment));
  const std::array<double, 4> parts{static_cast<double>(clock.hours().count()),
                                    static_cast<double>(clock.minutes().count()),
                                    static_cast<double>(clock.seconds().count()),
                                    static_cast<double>(clock.subseconds().count())};
  return unify_all(call, parts);
}

Outcome date(ActionCall& call) {
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(now(call)));
  const std::array<double, 3> parts{static_cast<double>(static_cast<int>(day.year())),
                                    static_cast<double>(static_cast<unsigned>(day.month())),
                                    static_cast<double>(static_cast<unsigned>(day.day()))};
  return unify_all(call, parts);
}

Outcome nano_time(ActionCall& call) {
  const double ms = call.agent() == nullptr ? 0 : call.agent()->host().now_ms();
  return call.result(0, Value::number(std::floor(ms * 1e6)));
}

Outcome version(ActionCall& call) {
  return call.result(0, call.heap().text("3.3.2"));  // of the language that is implemented
}

}  // namespace jaywalk::actions
