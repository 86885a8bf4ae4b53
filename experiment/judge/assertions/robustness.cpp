// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/assertions/robustness.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace jaywalk::stl {
namespace {

using Truths = std::vector<Truth>;
using Numbers = std::vector<double>;

/// `a - b`, where equal infinities do not differ.
double difference(double a, double b) { return a == b ? 0 : a - b; }

/// Replaces an undefined result (NaN) by 0.
double defined(double value) { return std::isnan(value) ? 0 : value; }

Truth compared(NodeKind kind, double a, double b, double tolerance) {
  if (std::abs(difference(a, b)) <= tolerance) b = a;
  const double more = difference(a, b);
  const double less = difference(b, a);
  switch (kind) {
    case NodeKind::less:
      return {less, less > 0};
    case NodeKind::less_equal:
      return {less, less >= 0};
    case NodeKind::greater:
      return {more, more > 0};
    case NodeKind::greater_equal:
      return {more, more >= 0};
    case NodeKind::equal:
      return {-std::abs(more), more == 0};
    case NodeKind::not_equal:
      return {std::abs(more), more != 0};
    default:
      std::abort();
  }
}

double computed(NodeKind kind, double a, double b) {
  switch (kind) {
    case NodeKind::add:
      return defined(a + b);
    case NodeKind::subtract:
      return difference(a, b);
    case NodeKind::multiply:
      return defined(a * b);
    case NodeKind::divide:
      return defined(a / b);
    case NodeKind::minimum:
      return std::min(a, b);
    case NodeKind::maximum:
      return std::max(a, b);
    default:
      std::abort();
  }
}

/// The least value of each window [i + from, i + to], as far as it lies within `values`: a queue of
/// indices whose values ascend, so that the front is the least.
Truths sliding_least(const Truths& values, TickWindow window) {
  const std::size_t count = values.size();
  Truths result(count, Truth::always());
  if (window.empty || window.from >= count) return result;
  const std::size_t to = std::min(window.to, count - 1);
  std::vector<std::size_t> queue(count);
  std::size_t front = 0;
  std::size_t back = 0;
  // From the end, so that values enter at the window's near edge. A window that begins behind the
  // record's end is empty, and the result keeps its value for an empty window.
  for (std::size_t i = count - window.from; i-- > 0;) {
    const std::size_t entering = i + window.from;
    while (back > front && !(values[queue[back - 1]] < values[entering])) --back;
    queue[back++] = entering;
    while (queue[front] > i + to) ++front;
    result[i] = values[queue[front]];
  }
  return result;
}

void negate(Truths& values) {
  for (Truth& value : values) value = !value;
}

Truths sliding_greatest(Truths values, TickWindow window) {
  negate(values);
  Truths result = sliding_least(values, window);
  negate(result);
  return result;
}

/// `holds until reached`, the window counted in ticks.
Truths until(const Truths& holds, const Truths& reached, TickWindow window) {
  const std::size_t count = holds.size();
  Truths result(count, Truth::never());
  if (window.empty || window.from >= count) return result;
  // `until` without a window, by its recursion from the end.
  Truths unbounded(count);
  Truth later = Truth::never();
  for (std::size_t i = count; i-- > 0;) {
    later = std::max(reached[i], std::min(holds[i], later));
    unbounded[i] = later;
  }
  // Donzé et al. 2013: bounded until is `eventually reached` in the window, `always holds` before
  // the window, and unbounded until at its beginning.
  const Truths within = sliding_greatest(reached, window);
  Truths before(count, Truth::always());
  if (window.from > 0) {
    before = sliding_least(holds, {.from = 0, .to = window.from - 1});
  }
  for (std::size_t i = 0; i + window.from < count; ++i) {
    result[i] = std::min({within[i], before[i], unbounded[i + window.from]});
  }
  return result;
}

enum class Time { future, past };

template <class Operator>
Truths in_time(Time time, Operator apply, Truths first, Truths second) {
  // The past operators are those of the future on the reversed record.
  if (time == Time::past) {
    std::ranges::reverse(first);
    std::ranges::reverse(second);
  }
  Truths result = apply(first, second);
  if (time == Time::past) std::ranges::reverse(result);
  return result;
}

class Evaluator {
 public:
  Evaluator(const Expression& expression, const Trace& trace, std::uint32_t self)
      : expression_(expression), trace_(trace), self_(self) {}

  [[nodiscard]] Truths condition(NodeId id) const {
    using enum NodeKind;
    const Node& node = expression_.node(id);
    const std::size_t count = trace_.ticks();
    if (is_comparison(node.kind)) return comparison(node);
    if (is_temporal(node.kind)) return temporal(node);
    switch (node.kind) {
      case truth:
        return Truths(count, node.number != 0 ? Truth::always() : Truth::never());
      case signal:
        return flags(trace_.signal(node, self_));
      case event:
        return flags(trace_.event(node, self_));
      case negation: {
        Truths result = condition(node.operands[0]);
        negate(result);
        return result;
      }
      case conjunction:
      case disjunction:
      case implication:
        return combination(node);
      case for_all:
      case exists:
        return quantified(node);
      default:
        assert(false && "types were checked");
        return Truths(count, Truth::never());
    }
  }

 private:
  static Truths flags(std::span<const double> values) {
    Truths result;
    result.reserve(values.size());
    for (const double value : values) {
      result.push_back(value != 0 ? Truth::always() : Truth::never());
    }
    return result;
  }

  [[nodiscard]] Truths comparison(const Node& node) const {
    const Numbers left = numbers(node.operands[0]);
    const Numbers right = numbers(node.operands[1]);
    Truths result(left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      result[i] = compared(node.kind, left[i], right[i], trace_.tolerance());
    }
    return result;
  }

  [[nodiscard]] Truths combination(const Node& node) const {
    Truths left = condition(node.operands[0]);
    const Truths right = condition(node.operands[1]);
    // `a -> b` is `!a | b`.
    if (node.kind == NodeKind::implication) negate(left);
    for (std::size_t i = 0; i < left.size(); ++i) {
      left[i] = node.kind == NodeKind::conjunction ? std::min(left[i], right[i])
                                                   : std::max(left[i], right[i]);
    }
    return left;
  }

  [[nodiscard]] Truths quantified(const Node& node) const {
    const bool all = node.kind == NodeKind::for_all;
    Truths result(trace_.ticks(), all ? Truth::always() : Truth::never());
    for (const std::uint32_t user : trace_.road_users()) {
      const Truths one = Evaluator(expression_, trace_, user).condition(node.operands[0]);
      for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = all ? std::min(result[i], one[i]) : std::max(result[i], one[i]);
      }
    }
    return result;
  }

  [[nodiscard]] Truths temporal(const Node& node) const {
    using enum NodeKind;
    const TickWindow window = tick_window(node.window, trace_.tick_s());
    const bool past = node.kind == historically || node.kind == once || node.kind == since;
    const Time time = past ? Time::past : Time::future;
    Truths first = condition(node.operands[0]);
    if (node.kind == NodeKind::until || node.kind == since) {
      return in_time(
          time, [&](const Truths& a, const Truths& b) { return stl::until(a, b, window); },
          std::move(first), condition(node.operands[1]));
    }
    const bool least = node.kind == always || node.kind == historically;
    return in_time(time,
                   [&](const Truths& a, const Truths&) {
                     return least ? sliding_least(a, window) : sliding_greatest(a, window);
                   },
                   std::move(first), {});
  }

  [[nodiscard]] Numbers numbers(NodeId id) const {
    using enum NodeKind;
    const Node& node = expression_.node(id);
    if (node.kind == number) return Numbers(trace_.ticks(), node.number);
    if (node.kind == signal) {
      const auto values = trace_.signal(node, self_);
      return {values.begin(), values.end()};
    }
    Numbers left = numbers(node.operands[0]);
    if (operand_count(node.kind) == 1) {
      for (double& value : left) value = node.kind == negative ? -value : std::abs(value);
      return left;
    }
    const Numbers right = numbers(node.operands[1]);
    for (std::size_t i = 0; i < left.size(); ++i) {
      left[i] = computed(node.kind, left[i], right[i]);
    }
    return left;
  }

  const Expression& expression_;
  const Trace& trace_;
  std::uint32_t self_;
};

/// Follows a condition that does not hold down to what violates it.
class Search {
 public:
  Search(const Expression& expression, const Trace& trace)
      : expression_(expression), trace_(trace) {}

  [[nodiscard]] std::size_t first(NodeId id, std::uint32_t self, std::size_t tick) const {
    using enum NodeKind;
    const Node& node = expression_.node(id);
    const TickWindow window = tick_window(node.window, trace_.tick_s());
    switch (node.kind) {
      case always:
        return first_within(node, self, tick, window);
      case eventually:
      case NodeKind::until:
        return end_of(window, tick);
      case conjunction:
        return in_conjunction(node, self, tick);
      case disjunction:
        return std::max(first(node.operands[0], self, tick), first(node.operands[1], self, tick));
      case implication:
        return first(node.operands[1], self, tick);
      case for_all:
        return of_road_users(node, tick);
      default:
        return tick;
    }
  }

 private:
  [[nodiscard]] std::size_t end_of(TickWindow window, std::size_t tick) const {
    const std::size_t last = trace_.ticks() - 1;
    if (window.empty || window.to > last - tick) return window.empty ? tick : last;
    return tick + window.to;
  }

  [[nodiscard]] std::size_t first_within(const Node& node, std::uint32_t self, std::size_t tick,
                                         TickWindow window) const {
    const Truths values = Evaluator(expression_, trace_, self).condition(node.operands[0]);
    for (std::size_t i = tick + window.from; i <= end_of(window, tick); ++i) {
      if (!values[i].holds) return first(node.operands[0], self, i);
    }
    return tick;
  }

  [[nodiscard]] std::size_t in_conjunction(const Node& node, std::uint32_t self,
                                           std::size_t tick) const {
    std::size_t earliest = trace_.ticks() - 1;
    for (const NodeId operand : node.operands) {
      if (Evaluator(expression_, trace_, self).condition(operand)[tick].holds) continue;
      earliest = std::min(earliest, first(operand, self, tick));
    }
    return earliest;
  }

  [[nodiscard]] std::size_t of_road_users(const Node& node, std::size_t tick) const {
    std::size_t earliest = trace_.ticks() - 1;
    for (const std::uint32_t user : trace_.road_users()) {
      if (Evaluator(expression_, trace_, user).condition(node.operands[0])[tick].holds) continue;
      earliest = std::min(earliest, first(node.operands[0], user, tick));
    }
    return earliest;
  }

  const Expression& expression_;
  const Trace& trace_;
};

}  // namespace

std::vector<Truth> evaluate(const Expression& expression, NodeId id, const Trace& trace,
                            std::uint32_t self) {
  return Evaluator(expression, trace, self).condition(id);
}

std::size_t first_violation(const Expression& expression, NodeId id, const Trace& trace,
                            std::uint32_t self, std::size_t tick) {
  return Search(expression, trace).first(id, self, tick);
}

TickWindow tick_window(const Window& window, double tick_s) {
  // A bound that is a whole number of ticks but for rounding is that number.
  constexpr double kRounding = 1e-9;
  constexpr double kFar = 1e15;
  const double from = std::ceil(window.from_s / tick_s - kRounding);
  const double to = std::floor(window.to_s / tick_s + kRounding);
  if (to < from) return {.empty = true};
  return {.from = static_cast<std::size_t>(std::min(from, kFar)),
          .to = static_cast<std::size_t>(std::min(to, kFar))};
}

}  // namespace jaywalk::stl
