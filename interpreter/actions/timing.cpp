// SPDX-License-Identifier: Apache-2.0
// The time of day. Internal actions that wait for a time or an event, and those that make one.

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/compile/term_reader.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

bool is_plan_part(Value value, Form form) {
  return value.is_structure() && value.structure()->form() == form;
}

// "now +3 s": milliseconds from now; -1: there is no amount; nothing: it is no whole number. As in
// Jason a unit that is none of its own counts milliseconds, and a blank stands before it.
std::optional<double> parse_delay(std::string_view text) {
  const auto trimmed = [](std::string_view part) {
    const std::size_t first = part.find_first_not_of(' ');
    return first == part.npos ? std::string_view() : part.substr(first);
  };
  text = trimmed(text.substr(3));
  if (!text.starts_with("+")) return -1;
  text = trimmed(text.substr(1));
  std::string_view amount = text.substr(0, text.find(' '));
  const std::string_view unit = trimmed(text.substr(amount.size()));
  if (amount.starts_with('+') && !amount.starts_with("+-")) amount.remove_prefix(1);
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(amount.data(), amount.data() + amount.size(), number);
  if (error != std::errc() || end != amount.data() + amount.size()) return std::nullopt;
  const double ms = number;
  if (unit == "s" || unit.starts_with("second")) return ms * 1000;
  if (unit == "m" || unit.starts_with("minute")) return ms * 60'000;
  if (unit == "h" || unit.starts_with("hour")) return ms * 3'600'000;
  if (unit == "d" || unit.starts_with("day")) return ms * 86'400'000;
  return ms;
}

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

Outcome wait(ActionCall& call) {
  Agent& agent = *call.agent();
  Wait wait;
  double ms = -1;
  const Value what = call.arg(0);
  TriggerParts trigger;
  if (what.is_number()) {
    ms = std::max(0.0, what.as_number());
  } else if (read_trigger(what, call, trigger)) {
    wait.has_trigger = true;
    wait.op = trigger.op;
    wait.kind = trigger.kind;
    wait.trigger = trigger.literal;
  } else if (is_literal(what) || is_plan_part(what, Form::logical) ||
             is_plan_part(what, Form::relation)) {
    const std::size_t trail = call.unifier().mark();
    if (call.machine().solve_term(what)) return Outcome::succeeded;
    call.unifier().undo(trail);
    wait.has_formula = true;
    wait.formula = what;
  } else if (what.is_text()) {
    return call.java_exception("the text is no trigger");
  } else {
    wait.has_formula = true;  // which never comes true
    wait.formula = Value::atom(predicates::falsity);
  }
  if (!what.is_number() && call.count() > 1) {
    if (!call.arg(1).is_number()) return call.java_exception("the time is no number");
    ms = std::max(0.0, call.arg(1).as_number());
    if (call.count() > 2) wait.elapsed = call.arg(2);
  }
  Waits(agent).start(*call.intention(), wait, ms);
  return Outcome::suspended;
}

Outcome at(ActionCall& call) {
  if (!call.arg(0).is_text()) return call.java_exception("the time is no string");
  const std::string_view time = call.arg(0).text()->view();
  if (!time.starts_with("now")) {
    return call.fail("internal_action",
                     fmt::format("The time parameter ('{}') of the internal action 'at' is not "
                                 "implemented!",
                                 time));
  }
  const std::optional<double> delay = parse_delay(time);
  if (!delay) return call.java_exception("the time of .at is no whole number");
  if (*delay == -1) {
    return call.fail("internal_action",
                     fmt::format("The time parameter ('{}') of the internal action 'at' did not "
                                 "parse correctly!",
                                 brief_text(call.arg(0), call.symbols())));
  }
  TriggerParts trigger;
  if (!read_trigger(call.arg(1), call, trigger) || !is_literal(trigger.literal)) {
    return call.wrong_argument(1, "a trigger like {+!g}");
  }
  Waits(*call.agent())
      .schedule({trigger.op, trigger.kind, call.unifier().fresh_copy(trigger.literal), nullptr, 0},
                std::max(0.0, *delay));
  return Outcome::succeeded;
}

Outcome signal(ActionCall& call) {
  TriggerParts trigger;
  if (!read_trigger(call.arg(0), call, trigger) || !is_literal(trigger.literal)) {
    return call.java_exception("the first argument is no trigger");
  }
  Value literal = call.unifier().fresh_copy(trigger.literal);
  const auto annotate = [&](Value annots) {
    literal = with_annotations(
        call.heap(), literal,
        union_of(call.heap(), literal_parts(literal).annots, annots, call.symbols()));
  };
  if (!has_source(literal_parts(literal).annots)) annotate(source_self());
  if (call.count() > 1 && call.arg(1).is_atom() &&
      call.symbols().functor(call.arg(1).atom_id()) == "type_signal") {
    trigger.kind = TriggerKind::belief;  // whatever was written
    const Value signal = Value::atom(call.symbols().predicate("signal", 0));
    annotate(call.heap().pair(signal, Value::empty_list()));
  }
  call.agent()->add_event({trigger.op, trigger.kind, literal, nullptr, 0});
  return Outcome::succeeded;
}

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
