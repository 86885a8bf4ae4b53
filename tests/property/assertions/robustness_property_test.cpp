// SPDX-License-Identifier: Apache-2.0
// Random expressions over random traces: the evaluator agrees with the definitions, carried out
// word for word by quantifiers over ticks, in the robustness and in whether the condition holds.

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "experiment/judge/assertions/robustness.h"
#include "tests/unit/assertions/traces.h"

namespace jaywalk::stl {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The definitions: one tick at a time, nothing shared, windows in seconds.
class Definitions {
 public:
  Definitions(const Expression& expression, const Trace& trace)
      : expression_(expression), trace_(trace) {}

  [[nodiscard]] double number(NodeId id, std::uint32_t self, int tick) const {
    const Node& node = expression_.node(id);
    if (node.kind == NodeKind::number) return node.number;
    if (node.kind == NodeKind::signal) {
      return trace_.signal(node, self)[static_cast<std::size_t>(tick)];
    }
    const double a = number(node.operands[0], self, tick);
    if (node.kind == NodeKind::negative) return -a;
    if (node.kind == NodeKind::absolute) return a < 0 ? -a : a;
    const double b = number(node.operands[1], self, tick);
    if (node.kind == NodeKind::add) return a + b;
    if (node.kind == NodeKind::subtract) return a - b;
    if (node.kind == NodeKind::multiply) return a * b;
    if (node.kind == NodeKind::minimum) return a < b ? a : b;
    if (node.kind == NodeKind::maximum) return a < b ? b : a;
    ADD_FAILURE() << "no number";
    return 0;
  }

  [[nodiscard]] double robustness(NodeId id, std::uint32_t self, int tick) const {
    const Node& node = expression_.node(id);
    const auto operand = [&](int which, int at) {
      return robustness(node.operands[static_cast<std::size_t>(which)], self, at);
    };
    const auto difference = [&] {
      return number(node.operands[0], self, tick) - number(node.operands[1], self, tick);
    };
    double result = 0;
    switch (node.kind) {
      case NodeKind::truth:
        return node.number != 0 ? kInf : -kInf;
      case NodeKind::signal:
        return trace_.signal(node, self)[static_cast<std::size_t>(tick)] != 0 ? kInf : -kInf;
      case NodeKind::less:
      case NodeKind::less_equal:
        return -difference();
      case NodeKind::greater:
      case NodeKind::greater_equal:
        return difference();
      case NodeKind::equal:
        return -std::abs(difference());
      case NodeKind::not_equal:
        return std::abs(difference());
      case NodeKind::negation:
        return -operand(0, tick);
      case NodeKind::conjunction:
        return std::min(operand(0, tick), operand(1, tick));
      case NodeKind::disjunction:
        return std::max(operand(0, tick), operand(1, tick));
      case NodeKind::implication:
        return std::max(-operand(0, tick), operand(1, tick));
      case NodeKind::always:
      case NodeKind::historically:
        result = kInf;
        for (const int at : window(node, tick)) result = std::min(result, operand(0, at));
        return result;
      case NodeKind::eventually:
      case NodeKind::once:
        result = -kInf;
        for (const int at : window(node, tick)) result = std::max(result, operand(0, at));
        return result;
      case NodeKind::until:
      case NodeKind::since:
        result = -kInf;
        for (const int at : window(node, tick)) {
          double both = operand(1, at);
          for (const int between : strictly_before(at, tick)) {
            both = std::min(both, operand(0, between));
          }
          result = std::max(result, both);
        }
        return result;
      case NodeKind::for_all:
        result = kInf;
        for (const std::uint32_t user : trace_.road_users()) {
          result = std::min(result, robustness(node.operands[0], user, tick));
        }
        return result;
      case NodeKind::exists:
        result = -kInf;
        for (const std::uint32_t user : trace_.road_users()) {
          result = std::max(result, robustness(node.operands[0], user, tick));
        }
        return result;
      default:
        ADD_FAILURE() << "no condition";
        return 0;
    }
  }

  [[nodiscard]] bool holds(NodeId id, std::uint32_t self, int tick) const {
    const Node& node = expression_.node(id);
    const auto operand = [&](int which, int at) {
      return holds(node.operands[static_cast<std::size_t>(which)], self, at);
    };
    const auto left = [&] { return number(node.operands[0], self, tick); };
    const auto right = [&] { return number(node.operands[1], self, tick); };
    switch (node.kind) {
      case NodeKind::truth:
        return node.number != 0;
      case NodeKind::signal:
        return trace_.signal(node, self)[static_cast<std::size_t>(tick)] != 0;
      case NodeKind::less:
        return left() < right();
      case NodeKind::less_equal:
        return left() <= right();
      case NodeKind::greater:
        return left() > right();
      case NodeKind::greater_equal:
        return left() >= right();
      case NodeKind::equal:
        return left() == right();
      case NodeKind::not_equal:
        return left() != right();
      case NodeKind::negation:
        return !operand(0, tick);
      case NodeKind::conjunction:
        return operand(0, tick) && operand(1, tick);
      case NodeKind::disjunction:
        return operand(0, tick) || operand(1, tick);
      case NodeKind::implication:
        return !operand(0, tick) || operand(1, tick);
      case NodeKind::always:
      case NodeKind::historically:
        for (const int at : window(node, tick)) {
          if (!operand(0, at)) return false;
        }
        return true;
      case NodeKind::eventually:
      case NodeKind::once:
        for (const int at : window(node, tick)) {
          if (operand(0, at)) return true;
        }
        return false;
      case NodeKind::until:
      case NodeKind::since:
        for (const int at : window(node, tick)) {
          bool all = operand(1, at);
          for (const int between : strictly_before(at, tick)) all = all && operand(0, between);
          if (all) return true;
        }
        return false;
      case NodeKind::for_all:
        for (const std::uint32_t user : trace_.road_users()) {
          if (!holds(node.operands[0], user, tick)) return false;
        }
        return true;
      case NodeKind::exists:
        for (const std::uint32_t user : trace_.road_users()) {
          if (holds(node.operands[0], user, tick)) return true;
        }
        return false;
      default:
        ADD_FAILURE() << "no condition";
        return false;
    }
  }

 private:
  static bool is_past(NodeKind kind) {
    return kind == NodeKind::historically || kind == NodeKind::once || kind == NodeKind::since;
  }

  /// The ticks of the trace whose distance in seconds lies within the window. The tests' times are
  /// sums of powers of two, so that nothing is rounded.
  [[nodiscard]] std::vector<int> window(const Node& node, int tick) const {
    std::vector<int> result;
    for (int at = 0; at < static_cast<int>(trace_.ticks()); ++at) {
      const double away = (is_past(node.kind) ? tick - at : at - tick) * trace_.tick_s();
      if (away >= node.window.from_s && away <= node.window.to_s) result.push_back(at);
    }
    return result;
  }

  /// For `until` the ticks from now to before `at`, for `since` those after `at` until now.
  static std::vector<int> strictly_before(int at, int tick) {
    std::vector<int> result;
    for (int each = tick; each < at; ++each) result.push_back(each);
    for (int each = tick; each > at; --each) result.push_back(each);
    return result;
  }

  const Expression& expression_;
  const Trace& trace_;
};

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {}

  int below(int bound) { return static_cast<int>(random_() % static_cast<std::uint32_t>(bound)); }

  std::string condition(int depth, bool quantified) {
    if (depth == 0 || below(8) == 0) return comparison();
    const std::string operand = condition(depth - 1, quantified);
    switch (below(12)) {
      case 0:
        return fmt::format("not ({})", operand);
      case 1:
        return fmt::format("({}) and ({})", operand, condition(depth - 1, quantified));
      case 2:
        return fmt::format("({}) or ({})", operand, condition(depth - 1, quantified));
      case 3:
        return fmt::format("({}) => ({})", operand, condition(depth - 1, quantified));
      case 4:
        return fmt::format("always{} ({})", window(), operand);
      case 5:
        return fmt::format("eventually{} ({})", window(), operand);
      case 6:
        return fmt::format("historically{} ({})", window(), operand);
      case 7:
        return fmt::format("once{} ({})", window(), operand);
      case 8:
      case 9:
        return fmt::format("({}) until{} ({})", operand, window(),
                           condition(depth - 1, quantified));
      case 10:
        return fmt::format("({}) since{} ({})", operand, window(),
                           condition(depth - 1, quantified));
      default:
        if (quantified) return operand;
        return fmt::format("{} ({})", below(2) == 0 ? "forall" : "exists",
                           condition(depth - 1, true));
    }
  }

  TestTrace trace() {
    const auto ticks = static_cast<std::size_t>(1 + below(14));
    constexpr std::array kTicks = {0.25, 0.5, 1.0, 2.0};
    TestTrace result(ticks, kTicks[static_cast<std::size_t>(below(4))],
                     static_cast<std::uint32_t>(1 + below(3)));
    for (std::uint32_t signal = 0; signal < 5; ++signal) {
      for (std::uint32_t user = 0; user <= 3; ++user) {
        std::vector<double> values(ticks);
        // Few different values, so that sides are often equal.
        for (double& value : values) value = signal == 2 ? below(2) : below(9) / 2.0 - 2;
        result.set(signal, user, std::move(values));
      }
    }
    return result;
  }

 private:
  std::string comparison() {
    constexpr std::array kSigns = {"<", "<=", ">", ">=", "==", "!="};
    if (below(8) == 0) return below(2) == 0 ? "p" : "true";
    return fmt::format("{} {} {}", number(2), kSigns[static_cast<std::size_t>(below(6))],
                       number(2));
  }

  std::string number(int depth) {
    constexpr std::array kNames = {"x", "y", "av.v", "time", "p1.x"};
    const std::string leaf =
        below(3) == 0 ? fmt::format("{}", below(5)) : kNames[static_cast<std::size_t>(below(5))];
    if (depth == 0 || below(2) == 0) return leaf;
    switch (below(7)) {
      case 0:
        return fmt::format("({} + {})", leaf, number(depth - 1));
      case 1:
        return fmt::format("({} - {})", leaf, number(depth - 1));
      case 2:
        return fmt::format("{} * {}", leaf, number(0));
      case 3:
        return fmt::format("min({}, {})", leaf, number(depth - 1));
      case 4:
        return fmt::format("max({}, {})", leaf, number(depth - 1));
      case 5:
        return fmt::format("abs({})", number(depth - 1));
      default:
        return "-" + leaf;
    }
  }

  std::string window() {
    const int from = below(10);
    const int to = from + below(8);
    switch (below(4)) {
      case 0:
        return "";
      case 1:
        return fmt::format("[{}, inf]", from / 4.0);
      default:
        return fmt::format("[{}, {}]", from / 4.0, to / 4.0);
    }
  }

  std::mt19937 random_;
};

TEST(Robustness, AgreesWithTheDefinitionsOnRandomExpressionsAndTraces) {
  constexpr std::uint32_t kCases = 10'000;
  std::size_t held = 0;
  std::size_t compared = 0;
  for (std::uint32_t seed = 0; seed < kCases; ++seed) {
    Generator generator(seed);
    const std::string text = generator.condition(3, false);
    const TestTrace trace = generator.trace();
    std::string errors;
    const auto parsed = expression(text, &errors);
    ASSERT_TRUE(parsed) << errors;
    const std::vector<Truth> truths = evaluate(*parsed, parsed->root, trace, 1);
    ASSERT_EQ(truths.size(), trace.ticks());
    const Definitions definitions(*parsed, trace);
    for (std::size_t tick = 0; tick < truths.size(); ++tick) {
      const auto at = static_cast<int>(tick);
      ASSERT_EQ(truths[tick].robustness, definitions.robustness(parsed->root, 1, at))
          << text << "\nseed " << seed << ", tick " << tick;
      ASSERT_EQ(truths[tick].holds, definitions.holds(parsed->root, 1, at))
          << text << "\nseed " << seed << ", tick " << tick;
      held += truths[tick].holds ? 1 : 0;
      ++compared;
    }
    if (!truths[0].holds) {
      ASSERT_LT(first_violation(*parsed, parsed->root, trace, 1, 0), trace.ticks()) << text;
    }
  }
  EXPECT_GT(held, compared / 5) << "the cases are not one-sided";
  EXPECT_LT(held, compared * 4 / 5);
}

}  // namespace
}  // namespace jaywalk::stl
