#include <algorithm>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/functions.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

Outcome extreme(ActionCall& call, int sign) {
  std::vector<Value> candidates;
  if (call.count() == 3) {
    call.solve(1, [&] {
      candidates.push_back(call.unifier().fresh_copy(call.applied(0)));
      return true;
    });
  } else {
    const Value list = call.applied(0);
    if (!list.is_list()) return call.wrong_argument(0, "a list");
    candidates = elements(list);
  }
  if (candidates.empty()) return Outcome::failed;
  Value best = candidates.front();
  for (const Value candidate : candidates) {
    if (compare_terms(candidate, best, call.symbols()) * sign > 0) best = candidate;
  }
  return call.result(call.count() - 1, best);
}

// Numbers from first to last; endless steps are refused by the caller.
class RangeSolutions : public Solutions {
 public:
  RangeSolutions(double next, double last, double step) : next_(next), last_(last), step_(step) {}
  bool next(ActionCall& call) override {
    while (step_ > 0 ? next_ <= last_ : next_ >= last_) {
      const double value = next_;
      next_ += step_;
      if (call.unify(0, Value::number(value))) return true;
    }
    return false;
  }

 private:
  double next_, last_, step_;
};

}  // namespace

Outcome member(ActionCall& call) {
  const Value list = call.arg(1);
  if (!list.is_list()) return call.wrong_argument(1, "a list");
  return call.many(std::make_unique<ValueSolutions>(0, elements(list)));
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
  const bool is_empty = value.is_empty_list() || (value.is_text() && value.text()->length == 0);
  return is_empty ? Outcome::succeeded : Outcome::failed;
}

Outcome nth(ActionCall& call) {
  const Value list = call.arg(1);
  if (!list.is_list()) return call.wrong_argument(1, "a list");
  const std::vector<Value> all = elements(list);
  const Value index = call.arg(0);
  if (index.is_number()) {
    const double at = index.as_number();
    if (!(at >= 0) || at >= static_cast<double>(all.size())) {
      return call.fail("internal_action", "nth: the index is out of range");
    }
    return call.result(2, all[static_cast<std::size_t>(at)]);
  }
  if (!index.is_variable()) return call.wrong_argument(0, "a number or a variable");
  class Indexes : public Solutions {
   public:
    explicit Indexes(std::vector<Value> values) : values_(std::move(values)) {}
    bool next(ActionCall& inner) override {
      while (next_ < values_.size()) {
        const std::size_t trail = inner.unifier().mark();
        const std::size_t at = next_++;
        if (inner.unify(2, values_[at]) && inner.unify(0, Value::number(static_cast<double>(at)))) {
          return true;
        }
        inner.unifier().undo(trail);
      }
      return false;
    }

   private:
    std::vector<Value> values_;
    std::size_t next_ = 0;
  };
  return call.many(std::make_unique<Indexes>(all));
}

Outcome reverse(ActionCall& call) {
  const Value value = call.arg(0);
  if (value.is_text()) {
    std::string text(value.text()->view());
    std::reverse(text.begin(), text.end());
    return call.result(1, call.heap().text(text));
  }
  if (!value.is_list()) return call.wrong_argument(0, "a list or a string");
  std::vector<Value> all = elements(value);
  std::reverse(all.begin(), all.end());
  return call.result(1, call.heap().list(all));
}

Outcome sort(ActionCall& call) {
  if (!call.arg(0).is_list()) return call.wrong_argument(0, "a list");
  std::vector<Value> all = elements(call.arg(0));
  std::stable_sort(all.begin(), all.end(), [&](Value a, Value b) {
    return compare_terms(a, b, call.symbols()) < 0;
  });
  return call.result(1, call.heap().list(all));
}

Outcome max(ActionCall& call) { return extreme(call, 1); }
Outcome min(ActionCall& call) { return extreme(call, -1); }

Outcome range(ActionCall& call) {
  for (std::size_t i = 1; i < call.count(); ++i) {
    if (!call.arg(i).is_number()) return call.wrong_argument(i, "a number");
  }
  const double first = call.arg(1).as_number();
  const double last = call.arg(2).as_number();
  const double step = call.count() == 4 ? call.arg(3).as_number() : 1;
  const Value x = call.arg(0);
  if (x.is_number()) {
    const bool inside = x.as_number() >= first && x.as_number() <= last;
    return inside ? Outcome::succeeded : Outcome::failed;
  }
  if (!(step < 0 || step > 0) || first + step == first) {
    return call.fail("internal_action", "range: the step makes no progress");
  }
  return call.many(std::make_unique<RangeSolutions>(first, last, step));
}

Outcome concat(ActionCall& call) {
  const std::size_t last = call.count() - 1;
  if (call.arg(0).is_list()) {
    std::vector<Value> all;
    for (std::size_t i = 0; i < last; ++i) {
      if (!call.arg(i).is_list()) return call.wrong_argument(i, "a list");
      const std::vector<Value> part = elements(call.arg(i));
      all.insert(all.end(), part.begin(), part.end());
    }
    return call.result(last, call.heap().list(all));
  }
  std::string text;
  for (std::size_t i = 0; i < last; ++i) {
    std::string part = text_of(call.arg(i), call.symbols());
    if (call.arg(i).is_atom() && part.size() > 1 && part.front() == '\'') {
      part = part.substr(1, part.size() - 2);
    }
    text += part;
    if (text.size() > (std::size_t{64} << 20U)) {
      return call.fail("limit", "concat: the text is longer than 64 MB");
    }
  }
  return call.result(last, call.heap().text(text));
}

}  // namespace jaywalk::actions
