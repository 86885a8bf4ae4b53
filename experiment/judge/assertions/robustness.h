// SPDX-License-Identifier: Apache-2.0
#pragma once

// The meaning of an expression over a test: at each tick, whether it holds and by how much. Read
// expression.h first.
//
// Robustness is that of Donzé and Maler, "Robust satisfaction of temporal logic over real-valued
// signals", FORMATS 2010, in discrete time: of a comparison the signed difference of its sides, of
// `and` the minimum, of `or` the maximum, of `not` the negative. A window [a, b] seconds covers the
// ticks at a distance of at least a and at most b that the test has; over no tick at all `always`
// and `historically` are plus infinity, `eventually`, `once`, `until` and `since` minus infinity.
// `p until q` asks for p at every tick before the one at which q holds, `p since q` for p at every
// tick after it. A robustness of 0 leaves open whether a condition holds (0 < 0 does not, 0 <= 0
// does); so both are computed, and they never contradict each other.
//
// Every operator takes time linear in the number of ticks: sliding minima are Lemire's ("Streaming
// maximum-minimum filter using no more than three comparisons per element", 2006), a bounded
// `until` is split as by Donzé, Ferrère and Maler, "Efficient robust monitoring for STL", CAV 2013.

#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "experiment/judge/assertions/expression.h"

namespace jaywalk::stl {

/// Whether a condition holds, and how far it is from changing: positive if it holds, negative if
/// not, 0 on the edge, where only `holds` decides. Ordered so that `and` is the lesser of two.
struct Truth {
  double robustness = 0;
  bool holds = false;

  [[nodiscard]] static constexpr Truth always() {
    return {std::numeric_limits<double>::infinity(), true};
  }
  [[nodiscard]] static constexpr Truth never() {
    return {-std::numeric_limits<double>::infinity(), false};
  }
  friend constexpr Truth operator!(Truth value) { return {-value.robustness, !value.holds}; }
  friend constexpr bool operator==(const Truth&, const Truth&) = default;
  friend constexpr bool operator<(const Truth& a, const Truth& b) {
    return a.robustness < b.robustness || (a.robustness == b.robustness && !a.holds && b.holds);
  }
};

/// The signals of a test over which expressions are evaluated.
class Trace {
 public:
  virtual ~Trace() = default;

  [[nodiscard]] virtual std::size_t ticks() const = 0;
  /// Seconds from one tick to the next.
  [[nodiscard]] virtual double tick_s() const = 0;
  /// The sides of a comparison are equal if they differ by no more than this.
  [[nodiscard]] virtual double tolerance() const { return 0; }
  /// The road users that `forall` and `exists` go through, as numbers for `self` below.
  [[nodiscard]] virtual std::span<const std::uint32_t> road_users() const = 0;
  /// The signal's values, one for each tick; those of a condition are 1 and 0. An infinity stands
  /// for what does not exist (no time to collision); no value is NaN.
  [[nodiscard]] virtual std::span<const double> signal(const Node& node,
                                                       std::uint32_t self) const = 0;
  /// The values of happens(kind), one for each tick: 1 and 0.
  [[nodiscard]] virtual std::span<const double> event(const Node& node,
                                                      std::uint32_t self) const = 0;
};

/// The condition `id` of the expression at every tick. `self` is the road user at hand; of no
/// meaning if the expression is not about one.
[[nodiscard]] std::vector<Truth> evaluate(const Expression& expression, NodeId id,
                                          const Trace& trace, std::uint32_t self);

/// The tick that shows that condition `id` does not hold at `tick`: for `always` the first at which
/// its operand does not hold, and there the operand's own violation; for `eventually` and `until`
/// the last of the window; for `and` and `forall` the earliest, for `or` the latest tick of its
/// parts. REQUIRES: it does not hold.
[[nodiscard]] std::size_t first_violation(const Expression& expression, NodeId id,
                                          const Trace& trace, std::uint32_t self, std::size_t tick);

/// The ticks that a window covers, as distances; empty if it lies between two ticks.
struct TickWindow {
  std::size_t from = 0;
  std::size_t to = 0;
  bool empty = false;
};
[[nodiscard]] TickWindow tick_window(const Window& window, double tick_s);

}  // namespace jaywalk::stl
