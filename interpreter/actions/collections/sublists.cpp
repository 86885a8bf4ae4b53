// Parts of lists and strings by backtracking: the longest first, the empty one last.

#include "interpreter/actions/actions.h"
#include "interpreter/actions/java/java_text.h"

namespace jaywalk::actions {
namespace {

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
