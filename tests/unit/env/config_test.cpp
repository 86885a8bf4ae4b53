// SPDX-License-Identifier: Apache-2.0
// Values of scenarios and what is said of wrong ones.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/config/parameter_settings.h"
#include "env/config/reader.h"
#include "env/config/section_reader.h"
#include "tests/helpers/config_nodes.h"

namespace jaywalk {
namespace {

using test::list;
using test::map;
using test::nothing;
using test::scalar;
using testing::AnyOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

/// A reader, and what it reports.
struct Reading {
  Diagnostics diagnostics;
  ConfigReader reader{diagnostics};

  [[nodiscard]] std::string said() const { return diagnostics.render(); }
};

TEST(ConfigNumbers, AreReadWithinTheirRange) {
  Reading reading;
  EXPECT_EQ(reading.reader.number(scalar("2.5"), {0, 10}), 2.5);
  EXPECT_EQ(reading.reader.number(scalar("-1e1"), {-10, 10}), -10);
  EXPECT_EQ(reading.reader.integer(scalar("7"), {0, 7}), 7);
  EXPECT_EQ(reading.said(), "");
}

TEST(ConfigNumbers, SayWhatWasExpectedAndWhatWasFound) {
  Reading reading;
  EXPECT_FALSE(reading.reader.number(scalar("11"), {0, 10}));
  EXPECT_FALSE(reading.reader.number(scalar("fast"), {0, 10}));
  EXPECT_FALSE(reading.reader.integer(scalar("1.5"), {0, 10}));
  EXPECT_FALSE(reading.reader.integer(list({"1"}), {0, 10}));
  EXPECT_FALSE(reading.reader.integer(map({}), {0, 10}));
  EXPECT_FALSE(reading.reader.number(nothing(), {0, 10}));
  EXPECT_EQ(reading.said(),
            "here: error: expected a number from 0 to 10, found '11'\n"
            "here: error: expected a number from 0 to 10, found 'fast'\n"
            "here: error: expected a whole number from 0 to 10, found '1.5'\n"
            "here: error: expected a whole number from 0 to 10, found a list\n"
            "here: error: expected a whole number from 0 to 10, found keys and values\n"
            "here: error: expected a number from 0 to 10, found nothing\n");
}

TEST(ConfigNumbers, AreWholeTexts) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  for (const char* text : {"", "1.5m", " 1", "1 ", "nan", "inf", "1e999", "+1", "0x10"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
  EXPECT_EQ(parse_integer("-12"), -12);
  for (const char* text : {"", "1.0", "1e3", "99999999999999999999"}) {
    EXPECT_FALSE(parse_integer(text)) << text;
  }
}

TEST(ConfigTexts, AreNotEmpty) {
  Reading reading;
  EXPECT_EQ(reading.reader.text(scalar("word"), "a word"), "word");
  EXPECT_FALSE(reading.reader.text(scalar(""), "a word"));
  EXPECT_FALSE(reading.reader.text(list({"a"}), "a word"));
  EXPECT_THAT(reading.said(), HasSubstr("expected a word, found ''"));
}

TEST(ConfigTexts, AreShortenedWhereTheyAreWrong) {
  Reading reading;
  (void)reading.reader.number(scalar(std::string(100, 'x')), {0, 1});
  EXPECT_THAT(reading.said(), HasSubstr("found '" + std::string(40, 'x') + "...'"));
}

TEST(ConfigIntervals, AreTwoNumbersOfWhichTheFirstIsNotTheGreater) {
  Reading reading;
  EXPECT_EQ(reading.reader.interval(list({"2", "5"}), {0, 9})->first, 2);
  EXPECT_EQ(reading.reader.interval(list({"2", "2"}), {0, 9})->last, 2);
  EXPECT_EQ(reading.said(), "");
  EXPECT_FALSE(reading.reader.interval(list({"5", "2"}), {0, 9}));
  EXPECT_FALSE(reading.reader.interval(list({"5"}), {0, 9}));
  EXPECT_FALSE(reading.reader.interval(scalar("5"), {0, 9}));
  EXPECT_FALSE(reading.reader.interval(list({"5", "10"}), {0, 9}));
  EXPECT_EQ(reading.said(),
            "here: error: the first number, 5, is greater than the last, 2\n"
            "here: error: expected two whole numbers, [first, last], found a list\n"
            "here: error: expected two whole numbers, [first, last], found '5'\n"
            "here: error: expected a whole number from 0 to 9, found '10'\n");
}

TEST(ConfigPairs, MayFallWhereTheirOrderDoesNotMatter) {
  Reading reading;
  EXPECT_FALSE(reading.reader.number_pair(list({"5", "2"}), {0, 9}));
  EXPECT_THAT(*reading.reader.number_pair(list({"5", "2"}), {0, 9}, PairOrder::any),
              ElementsAre(5, 2));
  EXPECT_EQ(reading.said(), "here: error: the first number, 5, is greater than the second, 2\n");
}

enum class Colour { red, green };
constexpr std::array kColours{Choice<Colour>{"red", Colour::red},
                              Choice<Colour>{"green", Colour::green}};

TEST(ConfigChoices, SuggestTheWordThatWasMeant) {
  Reading reading;
  EXPECT_EQ(reading.reader.choice(scalar("green"), std::span<const Choice<Colour>>(kColours)),
            Colour::green);
  EXPECT_FALSE(reading.reader.choice(scalar("gren"), std::span<const Choice<Colour>>(kColours)));
  EXPECT_EQ(reading.said(),
            "here: error: expected red or green, found 'gren'\n  hint: did you mean 'green'?\n");
}

TEST(ConfigMaps, AreReadInTheOrderOfTheirKeysWithDottedPaths) {
  Reading reading;
  std::vector<std::string> read;
  const auto note = [&](const ConfigNode& node, const std::string& path) {
    read.push_back(path + "=" + node.text);
  };
  const std::vector<ConfigKey> keys{{"a", note}, {"b", note}, {"c", note}};
  reading.reader.read_map(map({{"b", scalar("2")}, {"a", scalar("1")}}), "world", keys);
  reading.reader.read_map(map({{"c", scalar("3")}}), "", keys);
  EXPECT_THAT(read, ElementsAre("world.a=1", "world.b=2", "c=3"));
  EXPECT_EQ(reading.said(), "");
}

TEST(ConfigMaps, RefuseKeysThatTheyDoNotHave) {
  Reading reading;
  const auto ignore = [](const ConfigNode&, const std::string&) {};
  const std::vector<ConfigKey> keys{{"length", ignore}, {"width", ignore}};
  reading.reader.read_map(map({{"lenght", scalar("1")}}), "world", keys);
  reading.reader.read_map(map({{"zzz", scalar("1")}}), "", keys);
  reading.reader.read_map(scalar("3"), "world", keys);
  EXPECT_EQ(reading.said(),
            "key lenght: error: unknown key 'lenght' in 'world'\n"
            "  hint: did you mean 'length'?\n"
            "key zzz: error: unknown key 'zzz'\n"
            "  hint: the keys here are length, width\n"
            "here: error: expected keys and values (length, width), found '3'\n");
}

TEST(ConfigErrors, OfAnotherFileKeepTheirPlaceThere) {
  Reading reading;
  Diagnostics found;
  const auto source = std::make_shared<const Source>("other.yaml", "abc\n");
  found.error(SourceSpan{source, {1, 2}}, "wrong");
  found.error("other.asl", "is missing", "look for it");
  reading.reader.error_in({{}, "--scenario"}, found);
  EXPECT_THAT(reading.said(), HasSubstr("other.yaml:1:2: error: wrong\n"));
  EXPECT_THAT(reading.said(),
              HasSubstr("--scenario: error: the scenario cannot be read: other.asl: is missing\n"
                        "  hint: look for it\n"));
}

TEST(ConfigOrigins, AreThoseOfTheNearestKeyAbove) {
  const ValueOrigins origins{{"world", {{}, "of world"}}, {"world.av.speed", {{}, "of speed"}}};
  EXPECT_EQ(origin_of(origins, "world.av.speed", "s.yaml").option, "of speed");
  EXPECT_EQ(origin_of(origins, "world.av.rows", "s.yaml").option, "of world");
  EXPECT_EQ(origin_of(origins, "experiment", "s.yaml").option, "s.yaml");
}

/// The names of parameters with how many values they have.
std::vector<std::string> names_of(const std::vector<ParameterSetting>& settings) {
  std::vector<std::string> names;
  for (const ParameterSetting& each : settings) {
    names.push_back(each.name + "/" + std::to_string(each.values.size()));
  }
  return names;
}

TEST(Parameters, AreNumbersFractionsAtomsAndListsOfThese) {
  Reading reading;
  std::vector<ParameterSetting> settings;
  read_parameters(
      map({{"radius", scalar("15")}, {"odds", list({"1/4", "back"})}, {"way", scalar("left")}}),
      reading.reader, settings);
  EXPECT_EQ(reading.said(), "");
  EXPECT_THAT(names_of(settings), ElementsAre("radius/1", "odds/2", "way/1"));
  EXPECT_EQ(settings[0].values[0], ParameterValue(15.0));
  EXPECT_EQ(settings[1].values[0], ParameterValue(0.25));
  EXPECT_EQ(settings[1].values[1], ParameterValue(std::string("back")));
}

TEST(Parameters, AreReplacedByLaterOnesOfTheirName) {
  Reading reading;
  std::vector<ParameterSetting> settings{{"radius", {1.0}, {}}, {"way", {2.0}, {}}};
  read_parameters(map({{"radius", scalar("15")}}), reading.reader, settings);
  EXPECT_THAT(names_of(settings), ElementsAre("way/1", "radius/1"));
  EXPECT_EQ(settings[1].values[0], ParameterValue(15.0));
}

TEST(Parameters, RefuseWhatIsNoTerm) {
  Reading reading;
  std::vector<ParameterSetting> settings;
  read_parameters(map({{"Radius", scalar("15")},
                       {"a", scalar("true")},
                       {"b", scalar("1/0")},
                       {"c", scalar("X")},
                       {"d", map({})}}),
                  reading.reader, settings);
  EXPECT_THAT(settings, IsEmpty());
  EXPECT_THAT(reading.said(), HasSubstr("expected the name of a belief, found 'Radius'"));
  EXPECT_THAT(reading.said(), HasSubstr("found 'true'\n  hint: true and false are no terms"));
  EXPECT_THAT(reading.said(), HasSubstr("found '1/0'"));
  EXPECT_THAT(reading.said(), HasSubstr("found 'X'"));
  EXPECT_THAT(reading.said(), HasSubstr("found keys and values"));
}

TEST(Atoms, BeginWithASmallLetter) {
  for (const char* text : {"a", "aB_9", "left"}) EXPECT_TRUE(is_atom(text)) << text;
  for (const char* text : {"", "A", "_a", "9", "a b", "a.b", "é"})
    EXPECT_FALSE(is_atom(text)) << text;
}

TEST(ProgramPaths, AreFilesInstalledProgramsOrNamesOfBehaviours) {
  const SourceFiles files(std::string(JAYWALK_SOURCE_DIR "/agents"));
  const auto path_of = [&](const char* text) {
    return program_path("dir", text, "crossing", files);
  };
  EXPECT_EQ(path_of("mine.asl"), "dir/mine.asl");
  EXPECT_EQ(path_of("../mine.asl"), "mine.asl");
  EXPECT_EQ(path_of("/abs/mine.asl"), "/abs/mine.asl");
  EXPECT_EQ(path_of("sub/mine"), "dir/sub/mine");
  EXPECT_EQ(path_of("$jaywalk/motorway/a.asl"), "$jaywalk/motorway/a.asl");
  EXPECT_EQ(path_of("proximity"), "$jaywalk/crossing/proximity.asl");
  EXPECT_EQ(path_of("brink"), "$jaywalk/crossing/specialists/brink.asl");
  EXPECT_EQ(path_of("nobody"), "$jaywalk/crossing/nobody.asl");
}

TEST(ProgramPaths, OfNamesOfBehavioursAreFoundAmongCopies) {
  const std::array copies = {
      std::make_shared<const Source>("$jaywalk/crossing/specialists/brink.asl", "!a."),
      std::make_shared<const Source>("$jaywalk/crossing/specialists/tail.asl", "!a."),
      std::make_shared<const Source>("$jaywalk/crossing/tail.asl", "!a.")};
  const SourceFiles files(copies);
  EXPECT_EQ(program_path("dir", "brink", "crossing", files),
            "$jaywalk/crossing/specialists/brink.asl");
  EXPECT_EQ(program_path("dir", "tail", "crossing", files), "$jaywalk/crossing/tail.asl")
      << "as stores have it that were written when all behaviours were in one folder";
}

TEST(InstalledBehaviours, AreThoseOfTheWorldAndItsSpecialistsByName) {
  const SourceFiles files(std::string(JAYWALK_SOURCE_DIR "/agents"));
  const std::vector<std::string> paths = installed_behaviours("crossing", files);
  EXPECT_THAT(paths, IsSupersetOf({"$jaywalk/crossing/hunter.asl",
                                   "$jaywalk/crossing/specialists/brink.asl",
                                   "$jaywalk/crossing/specialists/tail.asl"}));
  EXPECT_THAT(paths, Each(Not(AnyOf(HasSubstr("/shared/"), HasSubstr("/tests/")))));
  EXPECT_EQ(paths.front(), "$jaywalk/crossing/specialists/brink.asl")
      << "the first of the alphabet";
}

}  // namespace
}  // namespace jaywalk
