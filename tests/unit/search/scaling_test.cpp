// SPDX-License-Identifier: Apache-2.0
// Robustness without a unit.

#include "search/suts/scaling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/judge/assertions/robustness.h"

namespace jaywalk::search {
namespace {

using namespace stl;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

constexpr SignalName kNames[] = {{.name = "speed", .owner = Owner::test},
                                 {.name = "rpm", .owner = Owner::test}};
constexpr SignalRange kRanges[] = {{0, 160}, {0, 6000}};

/// Two signals, a value each second.
class TwoSignals final : public Trace {
 public:
  TwoSignals(std::vector<double> speed, std::vector<double> rpm)
      : values_{std::move(speed), std::move(rpm)} {}

  [[nodiscard]] std::size_t ticks() const override { return values_[0].size(); }
  [[nodiscard]] double tick_s() const override { return 1; }
  [[nodiscard]] std::span<const std::uint32_t> road_users() const override { return {}; }
  [[nodiscard]] std::span<const double> signal(const Node& node, std::uint32_t) const override {
    return values_[node.signal];
  }
  [[nodiscard]] std::span<const double> event(const Node&, std::uint32_t) const override {
    return {};
  }

 private:
  std::vector<double> values_[2];
};

Expression expression(const std::string& text) {
  Diagnostics diagnostics;
  auto parsed = parse(expression_text(std::make_shared<const Source>("e", text)), diagnostics);
  auto resolved = resolve(std::move(*parsed), Vocabulary(kNames), {}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  return *resolved;
}

Truth of(const Expression& expression, const TwoSignals& signals) {
  return evaluate(expression, expression.root, signals, 0).front();
}

Truth scaled_truth(const std::string& text, const TwoSignals& signals) {
  Diagnostics diagnostics;
  const auto result = scaled(expression(text), kRanges, diagnostics);
  EXPECT_TRUE(result) << diagnostics.render();
  return result ? of(*result, signals) : Truth{};
}

std::string error_of(const std::string& text, std::span<const SignalRange> ranges) {
  Diagnostics diagnostics;
  EXPECT_FALSE(scaled(expression(text), ranges, diagnostics));
  return diagnostics.render();
}

TEST(Scaling, DividesByTheGreatestDifferenceThatThereCanBe) {
  // From -40 to 120: of these 120 is the greater one.
  EXPECT_DOUBLE_EQ(scaled_truth("always speed < 120", {{0, 90}, {0, 0}}).robustness, 0.25);
  EXPECT_DOUBLE_EQ(scaled_truth("always speed < 120", {{0, 150}, {0, 0}}).robustness, -0.25);
}

TEST(Scaling, ComparesConditionsOfDifferentUnits) {
  const TwoSignals signals({90}, {2000});
  const std::string both = "speed < 120 and rpm < 4000";
  EXPECT_DOUBLE_EQ(of(expression(both), signals).robustness, 30) << "that of speed";
  EXPECT_DOUBLE_EQ(scaled_truth(both, signals).robustness, 0.25) << "of 30 / 120 and 2000 / 4000";
}

TEST(Scaling, FollowsArithmetic) {
  // From 0 to 160 * 160; |rpm - 5000| is at most 5000.
  EXPECT_DOUBLE_EQ(scaled_truth("speed * speed < 0", {{80}, {0}}).robustness, -0.25);
  EXPECT_DOUBLE_EQ(scaled_truth("abs(rpm - 5000) > 0", {{0}, {0}}).robustness, 1);
  EXPECT_DOUBLE_EQ(scaled_truth("min(speed, 100) <= 100", {{50}, {0}}).robustness, 0.5);
  EXPECT_DOUBLE_EQ(scaled_truth("rpm / 2 > -speed", {{0}, {3000}}).robustness, 1500.0 / 3160);
}

TEST(Scaling, DoesNotChangeWhetherAConditionHolds) {
  for (const char* text : {"speed == 120", "speed != 120", "not (speed < 120 => rpm > 0)",
                           "speed < 120", "speed <= 120", "(speed < 100 until rpm > 10)",
                           "historically[0, 1] speed >= 120", "1 < 1", "true and speed > 3"}) {
    for (const TwoSignals& signals :
         {TwoSignals({120, 3}, {0, 11}), TwoSignals({0, 0}, {6000, 1})}) {
      EXPECT_EQ(scaled_truth(text, signals).holds, of(expression(text), signals).holds) << text;
    }
  }
}

TEST(Scaling, NeedsRangesAndSaysWhere) {
  constexpr SignalRange kNone[] = {{}, {0, 6000}};
  EXPECT_THAT(error_of("always speed < 120", kNone),
              HasSubstr("e:1:8: error: how far apart the two sides can be is not known"));
  EXPECT_THAT(error_of("1 / rpm < 3", kRanges), HasSubstr("divided by what may be 0"));
  EXPECT_THAT(error_of("speed > rpm and speed < inf", kRanges), HasSubstr("e:1:17"));
}

}  // namespace
}  // namespace jaywalk::search
