// SPDX-License-Identifier: Apache-2.0
// The keys of scenarios as docs/reference/scenarios.md has them, against what is read.

#include <cmath>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "parse.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_scenario::errors;
using testing_scenario::with;

/// A key with the numbers that it may be.
struct Ranged {
  std::string key;
  std::string fallback;
  double least = 0;
  double most = 0;
};

std::vector<std::string> parts_of(const std::string& text, const std::string& between) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at = text.find(between); at != std::string::npos;
       at = text.find(between, from)) {
    parts.push_back(text.substr(from, at - from));
    from = at + between.size();
  }
  parts.push_back(text.substr(from));
  return parts;
}

std::optional<double> number_of(const std::string& text) {
  if (text.empty() || text.find_first_not_of("-+.0123456789e") != std::string::npos) return {};
  return std::stod(text);
}

/// `1…100`, `1 to 100` or `±100`.
std::optional<std::pair<double, double>> range_of(const std::string& text) {
  constexpr std::string_view kEither = "±";
  if (text.starts_with(kEither)) {
    const std::optional<double> both = number_of(text.substr(kEither.size()));
    return both ? std::optional(std::pair(-*both, *both)) : std::nullopt;
  }
  for (const std::string between : {"…", " to "}) {
    const std::vector<std::string> ends = parts_of(text, between);
    if (ends.size() != 2) continue;
    const std::optional<double> least = number_of(ends[0]);
    const std::optional<double> most = number_of(ends[1]);
    if (least && most) return std::pair(*least, *most);
  }
  return std::nullopt;
}

/// The rows of the table that begins so, cell by cell.
std::vector<std::vector<std::string>> table_of(const std::string& head) {
  std::ifstream readme(JAYWALK_SOURCE_DIR "/docs/reference/scenarios.md");
  std::vector<std::vector<std::string>> rows;
  bool within = false;
  for (std::string line; std::getline(readme, line);) {
    within = within ? line.starts_with('|') : line.starts_with(head);
    if (within) rows.push_back(parts_of(line, " | "));
  }
  return rows;
}

std::string unquoted(std::string text) {
  std::erase(text, '`');
  std::erase(text, '|');
  std::erase(text, ' ');
  return text;
}

/// Keys of one number each, of the crossing and of what all worlds share.
std::vector<Ranged> shared_keys() {
  std::vector<Ranged> keys;
  for (const auto& row : table_of("| key | type, unit")) {
    const std::string key = unquoted(row[0]);
    // Simulators have keys of their own; lists are of several numbers.
    if (row.size() < 5 || key.find_first_of(",*[") != std::string::npos ||
        key.starts_with("world.simulator") || row[1].starts_with("list") ||
        row[1].find('[') != std::string::npos || row[1].starts_with("map")) {
      continue;
    }
    if (const auto range = range_of(row[3])) {
      const std::string fallback = parts_of(row[2], ":").front();
      keys.push_back({key, fallback, range->first, range->second});
    }
  }
  return keys;
}

/// Those of the motorway: `world.av.length`, `.width` have one range, or one each.
std::vector<Ranged> motorway_keys() {
  std::vector<Ranged> keys;
  for (const auto& row : table_of("| key of the motorway")) {
    if (row.size() < 4) continue;
    const std::vector<std::string> names = parts_of(row[0], ", ");
    const std::vector<std::string> ranges = parts_of(row[2], ", ");
    const std::string first = unquoted(names[0]);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto range = range_of(ranges.size() == 1 ? ranges[0] : ranges[i]);
      std::string key = unquoted(names[i]);
      if (key.starts_with('.')) key = first.substr(0, first.rfind('.')) + key;
      if (range) keys.push_back({key, parts_of(row[1], ", ").at(i), range->first, range->second});
    }
  }
  return keys;
}

std::vector<std::string> on_the_motorway(const std::string& setting) {
  return {"world.environment=motorway", setting};
}

std::vector<std::string> on_the_crossing(const std::string& setting) { return {setting}; }

/// Beyond either end nothing is taken, and the error says what would be.
void expect_ends(const std::vector<Ranged>& keys,
                 const std::function<std::vector<std::string>(const std::string&)>& settings) {
  for (const Ranged& each : keys) {
    for (const double beyond : {each.most + 1, each.least - 1}) {
      const Result<Scenario> read = with(settings(fmt::format("{}={}", each.key, beyond)));
      EXPECT_FALSE(read.ok()) << each.key << '=' << beyond;
      const std::string said = errors(read);
      const std::string begin = "number from ";
      const std::size_t from = said.find(begin);
      ASSERT_NE(from, std::string::npos) << each.key << ": " << said;
      const std::string rest = said.substr(from + begin.size());
      const auto range = range_of(rest.substr(0, rest.find(", found")));
      ASSERT_TRUE(range) << each.key << ": " << said;
      EXPECT_EQ(range->first, each.least) << each.key;
      EXPECT_EQ(range->second, each.most) << each.key;
    }
  }
}

/// The ends of ranges are accepted, but for combinations with other keys.
void expect_taken(const std::vector<Ranged>& keys,
                  const std::function<std::vector<std::string>(const std::string&)>& settings) {
  for (const Ranged& each : keys) {
    for (const double end : {each.least, each.most}) {
      const std::string said = errors(with(settings(fmt::format("{}={}", each.key, end))));
      EXPECT_THAT(said, Not(HasSubstr("expected"))) << each.key << '=' << end;
    }
  }
}

TEST(ScenarioKeys, AreManyWithARange) {
  EXPECT_GT(shared_keys().size(), 25U) << "or the reference has another form";
  EXPECT_GT(motorway_keys().size(), 7U);
}

TEST(ScenarioKeys, HaveTheRangesOfTheReference) { expect_ends(shared_keys(), on_the_crossing); }

TEST(ScenarioKeys, TakeTheEndsOfTheirRanges) { expect_taken(shared_keys(), on_the_crossing); }

TEST(ScenarioKeys, HaveTheDefaultsOfTheReference) {
  const Result<Scenario> plain = with({});
  int compared = 0;
  for (const Ranged& each : shared_keys()) {
    double number = 0;
    std::istringstream text(each.fallback);
    // An anchor is nothing without its reference system.
    if (!(text >> number) || !text.eof() || each.key.starts_with("world.anchor")) continue;
    ++compared;
    const Result<Scenario> same = with({each.key + '=' + each.fallback});
    ASSERT_TRUE(same.ok()) << errors(same);
    EXPECT_EQ(crossing_parameters(*same.value().world), crossing_parameters(*plain.value().world))
        << each.key;
    EXPECT_EQ(same.value().learning, plain.value().learning) << each.key;
    EXPECT_EQ(same.value().experiment.tests, plain.value().experiment.tests) << each.key;
    EXPECT_EQ(same.value().experiment.seed, plain.value().experiment.seed) << each.key;
    EXPECT_EQ(same.value().experiment.feedback, plain.value().experiment.feedback) << each.key;
  }
  EXPECT_GT(compared, 15);
}

TEST(ScenarioKeys, OtherThanTheirDefaultsChangeSomething) {
  const Result<Scenario> plain = with({});
  for (const Ranged& each : shared_keys()) {
    if (!each.key.starts_with("world.") || each.key.starts_with("world.anchor")) continue;
    const Result<Scenario> other =
        with({fmt::format("{}={}", each.key, std::min(each.most, each.least + 1))});
    if (!other.ok()) continue;  // it does not fit the others
    const auto& parameters = crossing_parameters(*other.value().world);
    const bool is_default = each.fallback == fmt::format("{}", std::min(each.most, each.least + 1));
    EXPECT_EQ(parameters == crossing_parameters(*plain.value().world), is_default) << each.key;
  }
}

TEST(MotorwayKeys, HaveTheRangesOfTheReference) { expect_ends(motorway_keys(), on_the_motorway); }

TEST(MotorwayKeys, TakeTheEndsOfTheirRanges) { expect_taken(motorway_keys(), on_the_motorway); }

TEST(MotorwayKeys, HaveTheDefaultsOfTheReference) {
  const Ground plain = with({"world.environment=motorway"}).value().world->ground();
  for (const Ranged& each : motorway_keys()) {
    const Result<Scenario> same = with(on_the_motorway(each.key + '=' + each.fallback));
    ASSERT_TRUE(same.ok()) << errors(same);
    const Ground ground = same.value().world->ground();
    ASSERT_EQ(ground.areas.size(), plain.areas.size()) << each.key;
    for (std::size_t i = 0; i < plain.areas.size(); ++i) {
      for (std::size_t corner = 0; corner < plain.areas[i].corners.size(); ++corner) {
        EXPECT_EQ(ground.areas[i].corners[corner].x_m, plain.areas[i].corners[corner].x_m);
        EXPECT_EQ(ground.areas[i].corners[corner].y_m, plain.areas[i].corners[corner].y_m);
      }
    }
    EXPECT_EQ(ground.cruise_mps, plain.cruise_mps) << each.key;
  }
}

/// The errors about a motorway with these settings.
std::string motorway_errors(std::vector<std::string> sets) {
  sets.insert(sets.begin(), "world.environment=motorway");
  return errors(with(std::move(sets)));
}

TEST(MotorwayKeys, HaveToFitEachOther) {
  EXPECT_THAT(motorway_errors({"world.lanes=2", "world.av.lane=3"}),
              HasSubstr("the AV's lane 3 is none of the 2"));
  EXPECT_THAT(motorway_errors({"world.lane_width=2", "world.av.width=2.5"}),
              HasSubstr("an AV of 2.5 m does not fit a lane of 2 m"));
  EXPECT_THAT(motorway_errors({"world.length=100", "world.av.start=100"}),
              HasSubstr("the road of 100 m ends before the AV's start"));
  EXPECT_THAT(motorway_errors({"world.drivers.greatest_speed=20"}),
              HasSubstr("drivers begin at the AV's speed, which is greater than their greatest"));
}

TEST(MotorwayKeys, AreFineWhereTheyJustFit) {
  EXPECT_EQ(motorway_errors({"world.lanes=3", "world.av.lane=3"}), "");
  EXPECT_EQ(motorway_errors({"world.lane_width=2", "world.av.width=2"}), "");
  EXPECT_EQ(motorway_errors({"world.drivers.greatest_speed=30"}), "");
}

TEST(MotorwayKeys, AreNoneOfTheCrossing) {
  EXPECT_THAT(motorway_errors({"world.crosswalks=[]"}), HasSubstr("unknown key 'crosswalks'"));
  EXPECT_THAT(errors(with({"world.lanes=2"})), HasSubstr("unknown key 'lanes'"));
}

}  // namespace
}  // namespace jaywalk
