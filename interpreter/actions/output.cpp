// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/java/java_format.h"
#include "interpreter/actions/java/java_text.h"
#include "interpreter/agent/agent.h"
#include "interpreter/compile/term_reader.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

std::string joined(ActionCall& call, std::size_t first) {
  const Unifier::KeepCircles keep(call.unifier());
  std::string text;
  for (std::size_t i = first; i < call.count(); ++i) {
    append_argument(text, call.applied(i), call.symbols());
  }
  return text;
}

// With `verbose=0` the text goes out as it is, without the agent's name.
Outcome print_line(ActionCall& call, std::string_view text, std::string_view end = "\n") {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::succeeded;
  if (agent->settings().verbosity == 0) {
    agent->host().write(*agent, text);
    agent->host().write(*agent, end);
  } else {
    agent->host().print(*agent, text);
  }
  return Outcome::succeeded;
}

// Java's text of a list that became a Java list: `[1, a]`.
std::string java_text_of(Value value, const SymbolTable& symbols) {
  value = deref(value);
  if (!value.is_list()) return text_of(value, symbols);
  std::string text;
  for (const Value element : elements(value)) {
    text += text.empty() ? "[" : ", ";
    text += java_text_of(element, symbols);
  }
  return text.empty() ? "[]" : text + ']';
}

// Double.toString, which shows a point even for whole numbers.
std::string double_text(double value) {
  std::string text = number_text(value);
  const bool whole = text.find_first_not_of("-0123456789") == text.npos;
  if (!whole) return text;
  if (text.size() <= 7) return text + ".0";
  // From ten millions on: d.dddE7.
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const std::size_t digits = text.size() - sign;
  if (digits <= 7) return text + ".0";
  text.insert(sign + 1, 1, '.');
  while (text.ends_with('0') && !text.ends_with(".0")) text.pop_back();
  return text + fmt::format("E{}", digits - 1);
}

FormatArgument format_argument(Value value, const SymbolTable& symbols) {
  FormatArgument arg;
  if (value.is_number()) {
    arg.kind = FormatArgument::Kind::number;
    arg.number = value.as_number();
    arg.text = double_text(arg.number);
    return arg;
  }
  arg.text = java_text_of(value, symbols);
  const bool truth = value.is_atom() && (value.atom_id() == predicates::truth ||
                                         value.atom_id() == predicates::falsity);
  if (truth) arg.kind = FormatArgument::Kind::truth;
  return arg;
}

// The end of `#{name}` whose name begins at `from`; 0 if it is not one.
std::size_t end_of_name(std::string_view text, std::size_t from) {
  const auto is_name = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
  };
  std::size_t end = from;
  while (end < text.size() && is_name(text[end])) ++end;
  return end > from && end < text.size() && text[end] == '}' ? end : 0;
}

void append_filled(std::string& out, ActionCall& call, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = text.substr(i, 2) == "#{" ? end_of_name(text, i + 2) : 0;
    if (end == 0) {
      out += text[i++];
      continue;
    }
    const std::string_view name = text.substr(i + 2, end - i - 2);
    const std::optional<Value> term = read_term(name, call);
    if (term) {
      out += text_of(call.unifier().apply(*term), call.symbols());
    } else {
      out += text.substr(i, end + 1 - i);
    }
    i = end + 1;
  }
}

}  // namespace

std::string text_of(Value value, const SymbolTable& symbols) {
  std::string text;
  value = deref(value);
  if (value.is_text()) {
    text = value.text()->view();
  } else {
    append_term(text, value, symbols);
  }
  return text;
}

Outcome print(ActionCall& call) { return print_line(call, joined(call, 0), ""); }

Outcome println(ActionCall& call) { return print_line(call, joined(call, 0)); }

Outcome printf(ActionCall& call) {
  if (!call.arg(0).is_text()) return call.java_exception("the first argument is no string");
  std::vector<FormatArgument> args;
  for (std::size_t i = 1; i < call.count(); ++i) {
    args.push_back(format_argument(call.arg(i), call.symbols()));
  }
  std::string text;
  std::string error;
  if (!format_as_java(call.arg(0).text()->view(), args, text, error)) {
    return call.java_exception(error);
  }
  return print_line(call, text);
}

Outcome puts(ActionCall& call) {
  if (!call.arg(0).is_text()) return call.wrong_argument(0, "a string");
  std::string text;
  for (std::size_t i = 0; i < call.count(); ++i) {
    if (call.arg(i).is_text()) append_filled(text, call, call.arg(i).text()->view());
    if (text.size() > kMaxTextBytes) return call.fail("limit", "the text is longer than 64 MB");
  }
  const std::size_t last = call.count() - 1;
  if (call.arg(last).is_variable()) return call.result(last, call.heap().text(text));
  return print_line(call, text);
}

Outcome log(ActionCall& call) {
  const Value level = call.arg(0);
  if (!is_java_literal(level)) {
    return call.java_exception("the first argument is none of severe, warning, info, fine, ...");
  }
  const std::string_view name =
      is_literal(level) ? call.symbols().functor(predicate_of(level)) : std::string_view();
  const bool is_fine = name == "fine" || name == "finer" || name == "finest";
  const bool is_warning = name == "severe" || name == "warning";
  const int verbosity = call.agent() == nullptr ? 1 : call.agent()->settings().verbosity;
  if (!is_warning && verbosity < (name == "fine" ? 2 : is_fine ? 3 : 1)) return Outcome::succeeded;
  const std::string text = joined(call, 1);
  if (!is_warning) return print_line(call, text);
  if (call.agent() != nullptr) call.agent()->log(text);
  return Outcome::succeeded;
}

Outcome verbose(ActionCall& call) {
  if (!call.arg(0).is_number()) return call.java_exception("the first argument is no number");
  if (call.agent() == nullptr) return Outcome::failed;
  ReasoningSettings settings = call.agent()->settings();
  settings.verbosity = static_cast<int>(std::clamp(call.arg(0).as_number(), 0.0, 2.0));
  call.agent()->set_settings(settings);
  return Outcome::succeeded;
}

Outcome print_unifier(ActionCall& call) {
  const std::span<const Symbol> names = call.unifier().slot_names();
  for (std::size_t i = 0; i < names.size() && call.slots() != nullptr; ++i) {
    const Value value = call.slots()[i];
    if (names[i] == names::unnamed || value.is_unset() || deref(value).is_variable()) continue;
    std::string line(call.symbols().text(names[i]));
    line += '=';
    append_term(line, call.unifier().apply(value), call.symbols());
    (void)print_line(call, line);
  }
  return print_line(call, "done");
}

}  // namespace jaywalk::actions
