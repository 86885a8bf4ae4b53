#include "interpreter/actions/java/java_character_class.h"

#include <string>

#include <gtest/gtest.h>

namespace jaywalk::actions {
namespace {

/// Which of the characters of ASCII that can be seen, and the blank, are in it.
std::string members(const CharacterClass& set) {
  std::string found;
  for (char32_t c = 0x20; c < 0x7F; ++c) {
    if (set.contains(c)) found += static_cast<char>(c);
  }
  return found;
}

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kUpper = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kLower = "abcdefghijklmnopqrstuvwxyz";
constexpr std::string_view kPunctuation = "!\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~";

std::string text(std::initializer_list<std::string_view> parts) {
  std::string all;
  for (const std::string_view part : parts) all += part;
  return all;
}

TEST(CharacterClass, HasTheEndsOfItsRanges) {
  const CharacterClass set{.ranges = {{'b', 'd'}, {'x', 'x'}}};
  EXPECT_EQ(members(set), "bcdx");
}

TEST(CharacterClass, MayBeAllTheOthers) {
  const CharacterClass set{.ranges = {{'!', 'y'}}, .negated = true};
  EXPECT_EQ(members(set), " z{|}~");
  EXPECT_TRUE(set.contains(0x1F6B6)) << "of all of Unicode";
}

TEST(CharacterClass, OfNoRangesIsEmptyOrEverything) {
  EXPECT_EQ(members({}), "");
  EXPECT_TRUE((CharacterClass{.negated = true}.contains('a')));
}

TEST(CharacterClass, MayNotMindCase) {
  const CharacterClass set{.ranges = {{'a', 'c'}, {'X', 'X'}}, .fold_case = true};
  EXPECT_EQ(members(set), "ABCXabcx");
  const CharacterClass others{.ranges = {{'a', 'a'}}, .negated = true, .fold_case = true};
  EXPECT_FALSE(others.contains('A'));
  EXPECT_TRUE(others.contains('b'));
}

TEST(CharacterClass, TakesInTheCharactersOfAnother) {
  CharacterClass set{.ranges = {{'a', 'a'}}};
  set.add(*predefined_class('d'));
  EXPECT_EQ(members(set), "0123456789a");
}

TEST(CharacterClass, TakesInTheGapsOfANegatedOne) {
  CharacterClass set;
  set.add(CharacterClass{.ranges = {{'!', '/'}, {'A', 'z'}}, .negated = true});
  EXPECT_EQ(members(set), " 0123456789:;<=>?@{|}~");
  EXPECT_TRUE(set.contains(0));
  EXPECT_TRUE(set.contains(0x10FFFF));
}

TEST(CharacterClass, TakesInAllOfANegatedOneWhoseRangesTouch) {
  CharacterClass set;
  set.add(CharacterClass{.ranges = {{0, '/'}, {'0', '8'}}, .negated = true});
  EXPECT_FALSE(set.contains('8'));
  EXPECT_TRUE(set.contains('9'));
  EXPECT_FALSE(set.contains(0));
}

TEST(PredefinedClasses, AreDigitsWordsAndBlanks) {
  EXPECT_EQ(members(*predefined_class('d')), kDigits);
  EXPECT_EQ(members(*predefined_class('w')), text({kDigits, kUpper, "_", kLower}));
  EXPECT_EQ(members(*predefined_class('s')), " ");
  for (const char blank : {'\t', '\n', '\v', '\f', '\r'}) {
    EXPECT_TRUE(predefined_class('s')->contains(static_cast<char32_t>(blank)));
  }
}

TEST(PredefinedClasses, OfACapitalAreTheComplement) {
  for (const char name : {'d', 'w', 's'}) {
    const CharacterClass set = *predefined_class(name);
    const CharacterClass other = *predefined_class(static_cast<char>(name - 'a' + 'A'));
    for (char32_t c = 0; c < 0x300; ++c)
      EXPECT_NE(set.contains(c), other.contains(c)) << static_cast<unsigned>(c);
  }
}

TEST(PredefinedClasses, AreNoOthers) {
  for (const char name : {'b', 'p', 'x', 'Z', '1'}) EXPECT_FALSE(predefined_class(name));
}

TEST(PropertyClasses, HaveTheirCharactersOfAscii) {
  EXPECT_EQ(members(*class_of_property("Upper")), kUpper);
  EXPECT_EQ(members(*class_of_property("Lower")), kLower);
  EXPECT_EQ(members(*class_of_property("Alpha")), text({kUpper, kLower}));
  EXPECT_EQ(members(*class_of_property("Digit")), kDigits);
  EXPECT_EQ(members(*class_of_property("Alnum")), text({kDigits, kUpper, kLower}));
  EXPECT_EQ(members(*class_of_property("Punct")), kPunctuation);
  EXPECT_EQ(members(*class_of_property("Space")), " ");
}

TEST(PropertyClasses, OfUnicodeKnowLettersBeyondAscii) {
  const CharacterClass letters = *class_of_property("L");
  for (const char32_t c : {U'é', U'Ω', U'ж', U'字'}) EXPECT_TRUE(letters.contains(c));
  EXPECT_FALSE(letters.contains(U'×')) << "a sign among the letters of Latin-1";
  EXPECT_FALSE(class_of_property("Alpha")->contains(U'é')) << "of ASCII alone";
}

TEST(PropertyClasses, AreNoOthers) {
  for (const char* name : {"", "Up", "upper", "IsLatin"}) EXPECT_FALSE(class_of_property(name));
}

TEST(WordCharacters, AreThoseOfTheClassOfWords) {
  const CharacterClass words = *predefined_class('w');
  for (char32_t c = 0; c < 0x180; ++c)
    EXPECT_EQ(is_word(c), words.contains(c)) << static_cast<unsigned>(c);
}

}  // namespace
}  // namespace jaywalk::actions
