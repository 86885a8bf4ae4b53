// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/java/java_regex.h"
#include "interpreter/actions/java/java_text.h"
#include "interpreter/compile/term_reader.h"
#include "interpreter/logic/machine.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

Outcome too_long(ActionCall& call) { return call.fail("limit", "the text is longer than 64 MB"); }

// A quoted atom loses its quotes.
std::string unquoted(Value value, const SymbolTable& symbols) {
  std::string text = text_of(value, symbols);
  if (value.is_atom() && text.size() > 1 && text.front() == '\'') {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

Outcome concat_lists(ActionCall& call) {
  const std::size_t last = call.count() - 1;
  if (!call.arg(last).is_list() && !call.arg(last).is_variable()) {
    return call.fail("internal_action",
                     fmt::format("Last argument of concat '{}'is not a list nor a variable.",
                                 brief_text(call.arg(last), call.symbols())));
  }
  std::vector<Value> all;
  for (std::size_t i = 0; i < last; ++i) {
    if (!call.arg(i).is_list()) {
      return call.wrong_arguments(fmt::format("arg[{}] is not a list", i));
    }
    // The last list is shared, not copied.
    if (i + 1 == last) return call.result(last, call.heap().list(all, call.arg(i)));
    std::vector<Value> part = elements(call.arg(i));
    if (all.empty()) {
      all = std::move(part);
    } else {
      all.insert(all.end(), part.begin(), part.end());
    }
    call.machine().check_memory(all.capacity() * sizeof(Value) + all.size() * sizeof(Pair));
  }
  return Outcome::succeeded;  // a lone list
}

Outcome replace_all(ActionCall& call, std::size_t result, const std::string& text,
                    const std::string& pattern, const std::string& by) {
  std::string error;
  std::optional<Regex> regex = Regex::parse(pattern, error);
  if (!regex) return call.java_exception(error);
  regex->watch([&call] { check_interruption(call); });
  const std::optional<std::string> replaced = regex->replace_all(text, by, error);
  if (!replaced) return call.java_exception(error);
  return call.result(result, call.heap().text(*replaced));
}

Outcome delete_range(ActionCall& call, std::int64_t start, std::int64_t end, std::size_t whole) {
  if (call.arg(whole).is_text()) {
    const std::string_view text = call.arg(whole).text()->view();
    const auto length = static_cast<std::int64_t>(utf16_length(text));
    const bool inside = start >= 0 && start <= length && end >= 0 && end <= length;
    if (!inside) return call.result(whole + 1, call.arg(whole));
    std::string kept(utf16_slice(text, 0, static_cast<std::size_t>(start)));
    kept += text.substr(byte_of_unit(text, static_cast<std::size_t>(end)));
    return call.result(whole + 1, call.heap().text(kept));
  }
  std::vector<Value> kept;
  std::int64_t i = 0;
  for (const Value element : elements(call.arg(whole))) {
    if (i < start || i >= end) kept.push_back(element);
    ++i;
  }
  return call.result(whole + 1, call.heap().list(kept));
}

// Removes what unifies. As in Jason the first that does gives the pattern's variables their values
// for the rest of the list; none of this is seen outside.
Outcome delete_elements(ActionCall& call) {
  const std::size_t trail = call.unifier().mark();
  std::vector<Value> kept;
  bool found = false;
  for (const Value element : elements(call.arg(1))) {
    const std::size_t before = call.unifier().mark();
    const bool same = call.unifier().unify(call.arg(0), element);
    if (!same) kept.push_back(element);
    if (!same || found) call.unifier().undo(before);
    found = found || same;
  }
  call.unifier().undo(trail);
  return call.result(2, call.heap().list(kept));
}

// The next place of a text, from a byte on; npos if there is none. As in Java the empty text does
// not occur behind the last character.
std::size_t next_occurrence(std::string_view text, std::string_view part, std::size_t from) {
  return from < text.size() ? text.find(part, from) : text.npos;
}

Outcome substring_positions(ActionCall& call, std::string part, std::string text) {
  return each(call, [part = std::move(part), text = std::move(text),
                     from = std::size_t{0}](ActionCall& inner) mutable {
    for (std::size_t at; (at = next_occurrence(text, part, from)) != text.npos;) {
      std::size_t size = 0;
      (void)character_at(text, at, size);
      from = at + size;
      const std::size_t trail = inner.unifier().mark();
      const auto position = static_cast<double>(utf16_length(std::string_view(text).substr(0, at)));
      const auto last = position + static_cast<double>(utf16_length(part)) - 1;
      if (inner.unify(2, Value::number(position)) &&
          (inner.count() < 4 || inner.unify(3, Value::number(last)))) {
        return true;
      }
      inner.unifier().undo(trail);
    }
    return false;
  });
}

// The part from a start up to, and not with, an end.
Outcome extract(ActionCall& call, std::size_t whole, std::size_t part) {
  const std::string text = text_of(call.arg(whole), call.symbols());
  const auto length = static_cast<std::int64_t>(utf16_length(text));
  const std::int64_t start = java_int(call.arg(2).as_number());
  const bool has_end = call.count() == 4 && call.arg(3).is_number();
  const std::int64_t end = has_end ? java_int(call.arg(3).as_number()) : length;
  if (start < 0 || end > length || start > end) {
    return call.java_exception("substring: the positions are out of bounds");
  }
  return call.result(part, call.heap().text(utf16_slice(text, static_cast<std::size_t>(start),
                                                        static_cast<std::size_t>(end))));
}

}  // namespace

Outcome concat(ActionCall& call) {
  if (call.arg(0).is_list()) return concat_lists(call);
  const std::size_t last = call.count() - 1;
  std::string text = unquoted(call.arg(0), call.symbols());
  for (std::size_t i = 1; i < last; ++i) {
    text += unquoted(call.arg(i), call.symbols());
    if (text.size() > kMaxTextBytes) return too_long(call);
  }
  if (call.arg(last).is_variable()) return call.result(last, call.heap().text(text));
  return when(text_of(call.arg(last), call.symbols()) == text);
}

Outcome delete_from(ActionCall& call) {
  const Value first = call.arg(0);
  if (first.is_number()) {
    const std::int64_t start = java_int(first.as_number());
    const bool has_end = call.count() == 4 && call.arg(1).is_number();
    const std::int64_t end = has_end ? java_int(call.arg(1).as_number()) : start + 1;
    const std::size_t whole = has_end ? 2 : 1;
    if (call.arg(whole).is_text() || call.arg(whole).is_list()) {
      return delete_range(call, start, end, whole);
    }
  }
  if (first.is_text()) {
    return replace_all(call, 2, text_of(call.arg(1), call.symbols()),
                       std::string(first.text()->view()), "");
  }
  if (call.arg(1).is_list()) return delete_elements(call);
  return call.fail("internal_action",
                   "Incorrect use of the internal action '.delete' (see documentation).");
}

Outcome substring(ActionCall& call) {
  if (call.count() == 2) {
    const std::string text = text_of(call.arg(1), call.symbols());
    return when(text.find(text_of(call.arg(0), call.symbols())) != text.npos);
  }
  if (call.arg(2).is_number() && call.arg(0).is_variable()) return extract(call, 1, 0);
  if (call.arg(2).is_number() && call.arg(1).is_variable()) return extract(call, 0, 1);
  return substring_positions(call, text_of(call.arg(0), call.symbols()),
                             text_of(call.arg(1), call.symbols()));
}

Outcome replace(ActionCall& call) {
  const Value pattern = call.arg(1);
  const Value by = call.arg(2);
  if (!pattern.is_text() || !by.is_text()) {
    return call.java_exception("the expression and what comes in its place are to be strings");
  }
  return replace_all(call, 3, text_of(call.arg(0), call.symbols()),
                     std::string(pattern.text()->view()), std::string(by.text()->view()));
}

Outcome lower_case(ActionCall& call) {
  const std::string text = lower_case_text(text_of(call.arg(0), call.symbols()));
  return call.result(1, call.heap().text(text));
}

Outcome upper_case(ActionCall& call) {
  const std::string text = upper_case_text(text_of(call.arg(0), call.symbols()));
  return call.result(1, call.heap().text(text));
}

Outcome term2string(ActionCall& call) {
  const Value term = call.arg(0);
  const Value text = call.arg(1);
  if (!term.is_variable()) {
    if (!text.is_text() && !text.is_variable()) {
      return call.fail("internal_action", "invalid case of term2string");
    }
    const std::string written = term_text(term, call.symbols());
    if (text.is_variable()) return call.result(1, call.heap().text(written));
    return when(written == text.text()->view());
  }
  const std::string written = text_of(text, call.symbols());
  const std::optional<Value> read = read_term(written, call);
  if (read) return call.result(0, call.unifier().apply(*read));
  return call.result(0, Value::atom(call.symbols().predicate(written, 0)));
}

}  // namespace jaywalk::actions
