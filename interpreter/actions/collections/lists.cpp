// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/functions.h"
#include "interpreter/actions/java/java_text.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

Outcome extreme(ActionCall& call, int sign) {
  std::vector<Value> candidates;
  std::size_t result = call.count() - 1;
  if (const Value list = deref(call.applied(0)); list.is_list()) {
    candidates = elements(list);
    result = 1;
  } else if (call.count() == 3) {
    if (!is_java_literal(deref(call.applied(1)))) {
      return call.java_exception("the second argument is no formula");
    }
    call.solve(1, [&] {
      // A copy, since the solution's bindings are undone before the next one.
      candidates.push_back(call.unifier().fresh_copy(call.applied(0)));
      return true;
    });
  } else {
    return call.wrong_argument(0, "a list when two arguments are used");
  }
  if (candidates.empty()) return Outcome::failed;
  Value best = candidates.front();
  for (const Value candidate : candidates) {
    if (compare_terms(candidate, best, call.symbols()) * sign > 0) best = candidate;
  }
  return call.result(result, best);
}

// Each character of a text, as a string of its own, by its index.
Value character_string(ActionCall& call, std::string_view text, std::size_t index) {
  return call.heap().text(utf16_slice(text, index, index + 1));
}

std::string reversed_text(std::string_view text) {
  std::string reversed(text.size(), '\0');
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); i += size) {
    (void)character_at(text, i, size);
    text.copy(reversed.data() + (text.size() - i - size), size, i);
  }
  return reversed;
}

Outcome nth_of_all(ActionCall& call, std::vector<Value> all) {
  return each(call, [all = std::move(all), next = std::size_t{0}](ActionCall& inner) mutable {
    while (next < all.size()) {
      const std::size_t trail = inner.unifier().mark();
      const std::size_t at = next++;
      if (inner.unify(2, all[at]) && inner.unify(0, Value::number(static_cast<double>(at)))) {
        return true;
      }
      inner.unifier().undo(trail);
    }
    return false;
  });
}

using SetOperation = std::vector<Value> (*)(const std::vector<Value>& a,
                                            const std::vector<Value>& b,
                                            const SymbolTable& symbols);

Outcome combine_sets(ActionCall& call, SetOperation operation) {
  const auto not_a_list = [&](std::string_view place, Value arg, std::string_view end) {
    return call.wrong_arguments(fmt::format("{} argument '{}'is not a list{}.", place,
                                            brief_text(arg, call.symbols()), end));
  };
  if (!call.arg(0).is_list()) return not_a_list("first", call.arg(0), "");
  if (!call.arg(1).is_list()) return not_a_list("second", call.arg(1), "");
  if (!call.arg(2).is_list() && !call.arg(2).is_variable()) {
    return not_a_list("last", call.arg(2), " nor a variable");
  }
  std::vector<Value> a = elements(call.arg(0));
  std::vector<Value> b = elements(call.arg(1));
  sort_as_set(a, call);
  sort_as_set(b, call);
  return call.result(2, call.heap().list(operation(a, b, call.symbols())));
}

auto less_than(const SymbolTable& symbols) {
  return [&symbols](Value a, Value b) { return compare_terms(a, b, symbols) < 0; };
}

// The starts of a text's characters and its end.
std::vector<std::size_t> character_starts(std::string_view text) {
  std::vector<std::size_t> starts;
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); i += size) {
    starts.push_back(i);
    (void)character_at(text, i, size);
  }
  starts.push_back(text.size());
  return starts;
}

constexpr std::string_view kPart = "a list, string, or a variable";
constexpr std::string_view kWhole = "either a list or a string";

bool fits(Value part) { return part.is_list() || part.is_text() || part.is_variable(); }

}  // namespace

bool collection_in(Value value, std::vector<Value>& all) {
  if (value.is_list()) {
    all = elements(value);
    return true;
  }
  if (!value.is_object() || value.object()->object->kind() == Object::Kind::map) return false;
  value.object()->object->visit([&](Value& element) { all.push_back(deref(element)); });
  return true;
}

namespace {

// In the order of terms. A long sort can be interrupted.
void sort_terms(std::vector<Value>& all, ActionCall& call) {
  constexpr std::uint64_t kBetweenLooks = 4096;
  std::uint64_t compared = 0;
  std::stable_sort(all.begin(), all.end(), [&, less = less_than(call.symbols())](Value a, Value b) {
    if (++compared % kBetweenLooks == 0) check_interruption(call);
    return less(a, b);
  });
}

class NumbersInTurn : public Solutions {
 public:
  explicit NumbersInTurn(CountedNumbers range) : range_(range) {}
  bool next(ActionCall& call) override {
    return !range_.is_done() && call.unify(0, Value::number(range_.take()));
  }
  [[nodiscard]] const CountedNumbers* numbers() const override { return &range_; }

 private:
  CountedNumbers range_;
};

}  // namespace

void check_interruption(ActionCall& call) {
  if (call.agent() == nullptr || !call.agent()->interrupted()) return;
  throw QueryLimit{"the action was interrupted", ReachedLimit::interruption};
}

void sort_as_set(std::vector<Value>& all, ActionCall& call) {
  sort_terms(all, call);
  const auto last = std::unique(all.begin(), all.end(), [&](Value a, Value b) {
    return compare_terms(a, b, call.symbols()) == 0;
  });
  all.erase(last, all.end());
}

Outcome member(ActionCall& call) {
  const Value list = call.arg(1);
  if (list.is_list()) {
    return each(call, [rest = list](ActionCall& inner) mutable {
      while (rest.is_pair()) {
        const Value element = rest.pair()->head;
        rest = deref(rest.pair()->tail);
        if (inner.unify(0, element)) return true;
      }
      return false;
    });
  }
  std::vector<Value> all;
  if (!collection_in(list, all)) return call.wrong_argument(1, "a list or a set");
  if (!is_ground(call.arg(0)))
    return call.many(std::make_unique<ValueSolutions>(0, std::move(all)));
  return when(std::any_of(all.begin(), all.end(),
                          [&](Value element) { return equal_terms(call.arg(0), element); }));
}

Outcome length(ActionCall& call) {
  Value result;
  const Value arg = call.arg(0);
  if (!functions::length_of(std::span(&arg, 1), call.heap(), call.symbols(), result)) {
    return Outcome::failed;
  }
  return call.result(1, result);
}

Outcome empty(ActionCall& call) {
  const Value value = call.arg(0);
  if (value.is_text()) return when(value.text()->length == 0);
  if (value.is_object()) return when(value.object()->object->size() == 0);
  return when(value.is_empty_list());
}

Outcome nth(ActionCall& call) {
  const Value index = call.arg(0);
  const Value whole = call.arg(1);
  if (!index.is_number() && !index.is_variable()) {
    return call.wrong_arguments(
        fmt::format("the first argument should be numeric or a variable -- not '{}'.",
                    brief_text(index, call.symbols())));
  }
  if (!whole.is_list() && !whole.is_text()) {
    return call.wrong_arguments(
        fmt::format("the second argument should be a list or string and not '{}'.",
                    brief_text(whole, call.symbols())));
  }
  if (index.is_number()) {
    const std::int32_t at = java_int(index.as_number());
    const auto out_of_range = [&] {
      const std::size_t size =
          whole.is_text() ? utf16_length(whole.text()->view()) : elements(whole).size();
      return call.fail("internal_action",
                       fmt::format("nth: index {} is out of bounds ({})", at, size));
    };
    if (at < 0) return out_of_range();
    if (whole.is_text()) {
      const std::string_view text = whole.text()->view();
      if (static_cast<std::size_t>(at) >= utf16_length(text)) return out_of_range();
      return call.result(2, character_string(call, text, static_cast<std::size_t>(at)));
    }
    Value rest = whole;
    for (std::int32_t i = 0; i < at && rest.is_pair(); ++i) rest = deref(rest.pair()->tail);
    return rest.is_pair() ? call.result(2, rest.pair()->head) : out_of_range();
  }
  if (whole.is_list()) return nth_of_all(call, elements(whole));
  std::vector<Value> characters;
  const std::string_view text = whole.text()->view();
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); i += size) {
    (void)character_at(text, i, size);
    characters.push_back(call.heap().text(text.substr(i, size)));
  }
  return nth_of_all(call, std::move(characters));
}

Outcome reverse(ActionCall& call) {
  const Value value = call.arg(0);
  const Value result = call.arg(1);
  const bool fits = value.is_list() ? result.is_list() : result.is_text();
  if (!fits && !result.is_variable()) {
    return call.wrong_arguments(fmt::format("last argument '{}' must be a {} or a variable.",
                                            brief_text(result, call.symbols()),
                                            value.is_list() ? "list" : "string"));
  }
  if (!value.is_list()) {
    if (!value.is_text()) {
      return call.wrong_arguments(
          fmt::format("first argument of .reverse '{}' must be a string or "
                      "a list",
                      brief_text(value, call.symbols())));
    }
    return call.result(1, call.heap().text(reversed_text(value.text()->view())));
  }
  std::vector<Value> all = elements(value);
  std::reverse(all.begin(), all.end());
  return call.result(1, call.heap().list(all));
}

Outcome sort(ActionCall& call) {
  if (!call.arg(0).is_list()) return call.wrong_argument(0, "a list");
  std::vector<Value> all = elements(call.arg(0));
  sort_terms(all, call);
  return call.result(1, call.heap().list(all));
}

Outcome shuffle(ActionCall& call) {
  if (!call.arg(0).is_list()) return call.wrong_argument(0, "a list");
  if (call.agent() == nullptr) return Outcome::failed;
  std::vector<Value> all = elements(call.arg(0));
  // Fisher and Yates, drawing as java.util.Random does.
  for (std::size_t i = all.size(); i > 1; --i) {
    const std::int32_t with = call.agent()->random().next_int(static_cast<std::int32_t>(i));
    std::swap(all[i - 1], all[static_cast<std::size_t>(with)]);
  }
  return call.result(1, call.heap().list(all));
}

Outcome max(ActionCall& call) { return extreme(call, 1); }
Outcome min(ActionCall& call) { return extreme(call, -1); }

Outcome set_union(ActionCall& call) {
  return combine_sets(call, [](const auto& a, const auto& b, const SymbolTable& symbols) {
    std::vector<Value> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result),
                   less_than(symbols));
    return result;
  });
}

Outcome set_intersection(ActionCall& call) {
  return combine_sets(call, [](const auto& a, const auto& b, const SymbolTable& symbols) {
    std::vector<Value> result;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result),
                          less_than(symbols));
    return result;
  });
}

Outcome set_difference(ActionCall& call) {
  return combine_sets(call, [](const auto& a, const auto& b, const SymbolTable& symbols) {
    std::vector<Value> result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result),
                        less_than(symbols));
    return result;
  });
}

Outcome range(ActionCall& call) {
  constexpr std::array<std::string_view, 4> kPlaces{"first", "second", "third", "fourth"};
  for (std::size_t i = 1; i < call.count(); ++i) {
    if (call.arg(i).is_number()) continue;
    return call.wrong_arguments(fmt::format("{} parameter ('{}') must be a number!", kPlaces.at(i),
                                            brief_text(call.arg(i), call.symbols())));
  }
  // Jason counts in whole numbers.
  const std::int64_t first = java_int(call.arg(1).as_number());
  const std::int64_t last = java_int(call.arg(2).as_number());
  const std::int64_t step = call.count() == 4 ? java_int(call.arg(3).as_number()) : 1;
  const Value x = call.arg(0);
  if (!x.is_variable()) {
    if (!x.is_number()) return call.java_exception("argument 1 of .range is not a number");
    // A given number is only compared: Jason does not look whether the steps meet it.
    const std::int64_t number = java_int(x.as_number());
    return when(number >= first && number <= last);
  }
  if (step == 0) return call.fail("internal_action", "range: the step makes no progress");
  return call.many(std::make_unique<NumbersInTurn>(CountedNumbers{first, last, step}));
}

Outcome prefix(ActionCall& call) {
  const Value part = call.arg(0);
  const Value whole = call.arg(1);
  if (!fits(part)) return call.wrong_argument(0, kPart);
  if (whole.is_text()) {
    const std::string_view text = whole.text()->view();
    if (part.is_text()) return when(text.starts_with(part.text()->view()));
    return each(call, [whole, starts = character_starts(text)](ActionCall& inner) mutable {
      if (starts.empty()) return false;
      const std::size_t end = starts.back();
      starts.pop_back();
      return inner.unify(0, inner.heap().text(whole.text()->view().substr(0, end)));
    });
  }
  if (!whole.is_list()) return call.wrong_argument(1, kWhole);
  const std::vector<Value> all = elements(whole);
  return each(call, [all, length = all.size() + 1](ActionCall& inner) mutable {
    while (length > 0) {
      --length;
      const Heap::Mark mark = inner.heap().mark();
      if (inner.unify(0, inner.heap().list(std::span(all).first(length)))) return true;
      inner.heap().release(mark);
    }
    return false;
  });
}

Outcome suffix(ActionCall& call) {
  const Value part = call.arg(0);
  const Value whole = call.arg(1);
  if (!fits(part)) return call.wrong_argument(0, kPart);
  if (whole.is_text()) {
    const std::string_view text = whole.text()->view();
    if (part.is_text()) return when(text.ends_with(part.text()->view()));
    return each(call, [whole, starts = character_starts(text),
                       i = std::size_t{0}](ActionCall& inner) mutable {
      if (i == starts.size()) return false;
      return inner.unify(0, inner.heap().text(whole.text()->view().substr(starts[i++])));
    });
  }
  if (!whole.is_list()) return call.wrong_argument(1, kWhole);
  return each(call, [all = elements(whole), start = std::size_t{0}](ActionCall& inner) mutable {
    while (start <= all.size()) {
      const Heap::Mark mark = inner.heap().mark();
      if (inner.unify(0, inner.heap().list(std::span(all).subspan(start++)))) return true;
      inner.heap().release(mark);
    }
    return false;
  });
}

Outcome sublist(ActionCall& call) {
  const Value part = call.arg(0);
  if (!part.is_list() && !part.is_variable()) return call.wrong_argument(0, "a list or a variable");
  if (!call.arg(1).is_list()) return call.wrong_argument(1, "a list");
  const std::vector<Value> all = elements(call.arg(1));
  return each(call, [all, start = std::size_t{0}, length = all.size()](ActionCall& inner) mutable {
    for (;;) {
      if (length == 0) {
        if (start > all.size()) return false;
        // Past the last start comes the empty list, once.
        ++start;
        if (start >= all.size()) {
          start = all.size() + 1;
          return inner.unify(0, Value::empty_list());
        }
        length = all.size() - start;
      }
      const Heap::Mark mark = inner.heap().mark();
      const std::size_t size = length--;
      if (inner.unify(0, inner.heap().list(std::span(all).subspan(start, size)))) return true;
      inner.heap().release(mark);
    }
  });
}

}  // namespace jaywalk::actions
