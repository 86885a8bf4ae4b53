// SPDX-License-Identifier: Apache-2.0
// Named inputs: values and signals in pieces, and requirements over what a program returns.

#include "search/suts/input_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "search/search_experiment.h"
#include "search/suts/requirements.h"

namespace jaywalk::search {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// An experiment with these keys of an external system.
Result<SearchExperiment> experiment(const std::string& keys) {
  return parse_search(
      std::make_shared<const Source>("e.yaml", "sut:\n  kind: external\n  command: [x]\n" + keys));
}

std::string errors(const std::string& keys) {
  const auto result = experiment(keys);
  return result.ok() ? "" : result.diagnostics().render();
}

constexpr auto kSignals = "  signals: {speed: [0, 160], rpm: [0, 6000]}\n";
constexpr auto kInputs = "  inputs: {throttle: [0, 100]}\n";

NamedInput signal(std::string name, double from, double to, std::size_t pieces,
                  Interpolation interpolation = Interpolation::constant) {
  return {.dimension = {.key = std::move(name), .from = from, .to = to},
          .pieces = pieces,
          .interpolation = interpolation};
}

TestInput at(std::vector<double> values) { return {Form::vector, std::move(values)}; }

TEST(InputSpace, HasADimensionForEachValueAndPiece) {
  const auto read = experiment(
      "  inputs:\n    throttle: [0, 100]\n    brake: {range: [0, 325], pieces: 6}\n"
      "    lanes: {whole: [1, 5], step: 2}\n    weather: [rain, fog, sun]\n  measures: [m]\n");
  ASSERT_TRUE(read.ok()) << read.diagnostics().render();
  const SearchSpace& space = read.value().plan.model->space();
  EXPECT_EQ(space.dimension(), 9U);
  EXPECT_THAT(space.distinct_values(), ElementsAre(0, 0, 0, 0, 0, 0, 0, 3, 3));
  EXPECT_EQ(space.describe(at({0, -1, 1, 0, 0, 0, 0, 1, -1})),
            "throttle 50, brake 0 325 162.5 162.5 162.5 162.5, lanes 5, weather rain");
  EXPECT_TRUE(space.check(at(std::vector<double>(9, 1))).valid());
  EXPECT_FALSE(space.check(at(std::vector<double>(8, 1))).valid());
  EXPECT_FALSE(space.check(at(std::vector<double>(9, 1.1))).valid());
}

TEST(InputSpace, SendsValuesAndPieces) {
  NamedInput lanes{
      .dimension = {.key = "lanes", .from = 1, .to = 5, .kind = Dimension::Kind::whole},
      .pieces = 2};
  NamedInput word{.dimension = {.key = "kind", .kind = Dimension::Kind::word, .words = {"a", "7"}}};
  const InputSpace space(
      {.inputs = {signal("gain", 0, 1, 0), signal("brake", 0, 10, 2), lanes, word},
       .duration_s = 30});
  EXPECT_EQ(
      space.request(at({0, -1, 1, -1, 1, -1})).dump(),
      R"({"duration_s":30.0,"inputs":{"brake":[0.0,10.0],"gain":0.5,"kind":"a","lanes":[1,5]}})");
  EXPECT_EQ(space.request(at({0, -1, 1, -1, 1, 1}))["inputs"]["kind"], 7);
}

TEST(InputSpace, SamplesPiecesThatLastEquallyLong) {
  const InputSpace space({.inputs = {signal("u", 0, 10, 2)}, .duration_s = 0.4, .sample_s = 0.1});
  const auto json = space.request(at({-1, 1}));
  EXPECT_EQ(json["inputs"]["u"].dump(), "[0.0,0.0,10.0,10.0,10.0]") << "from the piece's beginning";
  EXPECT_THAT(json["time"], SizeIs(5));
}

TEST(InputSpace, InterpolatesBetweenPoints) {
  const InputSpace space(
      {.inputs = {signal("u", 0, 10, 3, Interpolation::linear)}, .duration_s = 4, .sample_s = 1});
  EXPECT_EQ(space.request(at({-1, 1, 0}))["inputs"]["u"].dump(), "[0.0,5.0,10.0,7.5,5.0]");
  const InputSpace one(
      {.inputs = {signal("u", 0, 10, 1, Interpolation::linear)}, .duration_s = 1, .sample_s = 1});
  EXPECT_EQ(one.request(at({0}))["inputs"]["u"].dump(), "[5.0,5.0]");
}

TEST(InputKeys, SayWhatIsWrongAndWhere) {
  const std::string text = errors(
      "  duration_s: 0\n  inputs:\n    throttle: {range: [0, 100], peices: 6}\n    brake: [325, "
      "0]\n"
      "    'a b': [0, 1]\n    gear: {pieces: 3}\n    both: {range: [0, 1], whole: [0, 1]}\n"
      "    many: {range: [0, 1], pieces: 0}\n    one: {range: [0, 1], interpolation: linear}\n"
      "  measures: [m]\n");
  for (const char* expected :
       {"e.yaml:4:15: error: expected a number from 1e-06",
        "e.yaml:6:33: error: unknown key 'peices' in 'sut.inputs.throttle'",
        "did you mean 'pieces'?",
        "e.yaml:7:12: error: the first number, 325, is greater than the second, 0",
        "e.yaml:8:5: error: 'a b' cannot be the name of an input",
        "e.yaml:9:11: error: 'sut.inputs.gear' has no range",
        "'sut.inputs.both' has both 'range' and 'whole'",
        "expected a whole number from 1 to 1000, found '0'",
        "'sut.inputs.one' is one value, no signal"}) {
    EXPECT_THAT(text, HasSubstr(expected));
  }
}

TEST(InputKeys, DoNotContradictEachOther) {
  EXPECT_THAT(errors(std::string(kInputs) + "  roads: {curvatures: 3}\n  measures: [m]\n"),
              HasSubstr("e.yaml:5:10: error: the program gets roads or 'inputs', not both"));
  EXPECT_THAT(errors("  duration_s: 3\n"), HasSubstr("'duration_s' is of signals among 'inputs'"));
  EXPECT_THAT(errors(kInputs), HasSubstr("nothing says how bad a test was"));
  EXPECT_THAT(errors("  inputs: {}\n  measures: [m]\n"),
              HasSubstr("names of inputs and their ranges"));
  EXPECT_THAT(errors(std::string(kInputs) + "  sample_s: 1\n  measures: [m]\n"),
              HasSubstr("samples of signals whose duration is not given"));
  EXPECT_THAT(errors("  inputs: {u: {range: [0, 1], pieces: 2, interpolation: linear}}\n"
                     "  measures: [m]\n"),
              HasSubstr("linear signals are sent as samples"));
  EXPECT_THAT(errors("  inputs: {u: {whole: [0, 1], pieces: 2, interpolation: linear}}\n"
                     "  measures: [m]\n"),
              HasSubstr("between whole numbers nothing is interpolated"));
  EXPECT_THAT(
      errors("  inputs: {u: {range: [0, 1], pieces: 600}, v: {range: [0, 1], pieces: 600}}\n"
             "  measures: [m]\n"),
      HasSubstr("the inputs have 1200 values in all, more than 1000"));
  EXPECT_THAT(errors("  inputs: {u: {range: [0, 1], pieces: 2}}\n  duration_s: 1000\n"
                     "  sample_s: 0.001\n  measures: [m]\n"),
              HasSubstr("more than 100000 samples"));
}

TEST(RequirementKeys, BecomeMeasuresAndTheFitness) {
  const auto read = experiment(std::string(kInputs) + kSignals +
                               "  requirements:\n    slow: always[0, 20] speed < 120\n"
                               "    calm: {requirement: always rpm < 4750, scale: 100}\n"
                               "  measures: [fuel]\n");
  ASSERT_TRUE(read.ok()) << read.diagnostics().render();
  std::vector<std::string> names;
  for (const MeasureKind& kind : read.value().plan.model->measures()) names.emplace_back(kind.name);
  EXPECT_THAT(names, ElementsAre("robustness", "slow_robustness", "slow_scaled", "calm_robustness",
                                 "calm_scaled", "fuel"));
  EXPECT_THAT(requirements_of(read.value().plan.model->measures()), ElementsAre(1, 3));
  const Fitness& fitness = read.value().plan.fitness;
  EXPECT_EQ(fitness.measure, 0U);
  EXPECT_TRUE(fitness.fails(fitness.of({.measures = {0}})));
  EXPECT_FALSE(fitness.fails(fitness.of({.measures = {1e-12}}))) << "it was kept";
  EXPECT_EQ(fitness.of({.measures = {1}}), 0);
}

TEST(RequirementKeys, CanBeSearchedOneByOne) {
  const std::string keys =
      std::string(kInputs) + kSignals + "  requirements: {slow: always speed < 120}\n";
  const auto read = experiment(keys + "fitness: {measure: slow_scaled}\n");
  ASSERT_TRUE(read.ok()) << read.diagnostics().render();
  EXPECT_EQ(read.value().measure, "slow_scaled");
  EXPECT_EQ(read.value().plan.fitness.worst, 0);
  EXPECT_EQ(read.value().plan.fitness.fails_at, 1);
  EXPECT_THAT(errors(keys + "fitness: {measure: slow_robustness, worst: 0}\n"),
              AllOf(HasSubstr("'slow_robustness' needs 'harmless' and 'worst'"),
                    HasSubstr("'slow_scaled' has none")));
  EXPECT_EQ(errors(keys + "fitness: {measure: slow_robustness, harmless: 120, worst: 0}\n"), "");
}

TEST(RequirementKeys, PointIntoTheCondition) {
  const std::string text = errors(
      std::string(kInputs) + kSignals +
      "  requirements:\n    a: always sped < 120\n    b: always[0, 20 speed < 120\n"
      "    c: forall speed > 1\n    d: speed + rpm\n    'e f': speed > 1\n    g: {scale: 1}\n"
      "    h: {requirement: speed > 1, scale: 0}\n    i: happens(crash)\n    j: distance > 1\n");
  for (const char* expected :
       {"e.yaml:7:15: error: unknown signal 'sped'", "did you mean 'speed'?",
        "e.yaml:8:21: error: expected ']', found 'speed'",
        "e.yaml:9:8: error: a program's signals are of no road user",
        "e.yaml:10:8: error: expected a condition, found a number",
        "e.yaml:11:5: error: 'e f' cannot be the name of a requirement",
        "'sut.requirements.g' has no 'requirement'", "expected a number from 1e-09",
        "e.yaml:14:8: error: a program's signals are of no road user",
        "e.yaml:15:8: error: unknown signal 'distance'", "the signals here are time, speed, rpm"}) {
    EXPECT_THAT(text, HasSubstr(expected));
  }
}

TEST(RequirementKeys, NeedSignalsWithRangesOrAScale) {
  EXPECT_THAT(errors(std::string(kInputs) + "  requirements: {a: speed > 1}\n"),
              HasSubstr("requirements of signals that are not named"));
  const std::string keys = std::string(kInputs) + "  signals: [speed]\n  requirements:\n";
  EXPECT_THAT(
      errors(keys + "    a: always speed < 120\n"),
      AllOf(HasSubstr("e.yaml:7:15: error: how far apart the two sides can be is not known"),
            HasSubstr("or the requirement a 'scale'")));
  EXPECT_EQ(errors(keys + "    a: {requirement: always speed < 120, scale: 120}\n"), "");
}

TEST(SignalKeys, AreNamesOfTheLanguage) {
  const std::string rest = "  measures: [m]\n";
  EXPECT_THAT(errors(std::string(kInputs) + "  signals: [time, max, a b, speed, speed]\n" + rest),
              AllOf(HasSubstr("'time' is there always"), HasSubstr("'max' cannot be the name"),
                    HasSubstr("'a b' cannot be the name"), HasSubstr("a second signal 'speed'")));
  EXPECT_THAT(errors(std::string(kInputs) + "  signals: {speed: [3, 1]}\n" + rest),
              HasSubstr("the first number, 3, is greater"));
  EXPECT_THAT(errors(std::string(kInputs) + "  signals: speed\n" + rest),
              HasSubstr("names of signals"));
}

TEST(MeasureKeys, HaveNamesOfTheirOwn) {
  EXPECT_THAT(
      errors(std::string(kInputs) + kSignals + "  requirements: {a: always speed < 1}\n" +
             "  measures: [test, speed, a_scaled, fuel, fuel]\n"),
      AllOf(HasSubstr("'test' cannot be the name of a measure"), HasSubstr("'speed' cannot"),
            HasSubstr("'a_scaled' cannot"), HasSubstr("'fuel' cannot")));
}

TEST(Times, RiseEvenly) {
  EXPECT_EQ(why_no_times(std::vector<double>{0, 0.1, 0.2, 0.3}), "");
  EXPECT_EQ(why_no_times(std::vector<double>{5, 6}), "");
  EXPECT_THAT(why_no_times(std::vector<double>{0}), HasSubstr("fewer than two values"));
  EXPECT_THAT(why_no_times(std::vector<double>{0, 1, 1}), HasSubstr("does not rise from 1 to 1"));
  EXPECT_THAT(why_no_times(std::vector<double>{0, 1, 3}), HasSubstr("must be equal"));
}

}  // namespace
}  // namespace jaywalk::search
