#include "interpreter/actions/java/java_character_class.h"

#include <algorithm>

#include "interpreter/actions/java/java_text.h"

namespace jaywalk::actions {

bool CharacterClass::contains(char32_t character) const {
  const auto holds = [this](char32_t c) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [c](const Range& range) { return range.first <= c && c <= range.last; });
  };
  const bool found =
      holds(character) ||
      (fold_case && (holds(lower_case_of(character)) || holds(upper_case_of(character))));
  return found != negated;
}

void CharacterClass::add(const CharacterClass& other) {
  if (!other.negated) {
    ranges.insert(ranges.end(), other.ranges.begin(), other.ranges.end());
    return;
  }
  char32_t next = 0;  // the gaps between the ranges
  for (const Range& range : other.ranges) {
    if (range.first > next) ranges.push_back({next, range.first - 1});
    next = range.last + 1;
  }
  ranges.push_back({next, 0x10FFFF});
}

std::optional<CharacterClass> predefined_class(char name) {
  CharacterClass set;
  switch (name) {
    case 'd':
    case 'D':
      set.ranges = {{'0', '9'}};
      break;
    case 'w':
    case 'W':
      set.ranges = {{'0', '9'}, {'A', 'Z'}, {'_', '_'}, {'a', 'z'}};
      break;
    case 's':
    case 'S':
      set.ranges = {{'\t', '\r'}, {' ', ' '}};
      break;
    default:
      return std::nullopt;
  }
  set.negated = name < 'a';
  return set;
}

std::optional<CharacterClass> class_of_property(std::string_view name) {
  CharacterClass set;
  if (name == "Lu" || name == "Upper") {
    set.ranges = {{'A', 'Z'}};
  } else if (name == "Ll" || name == "Lower") {
    set.ranges = {{'a', 'z'}};
  } else if (name == "Alpha") {
    set.ranges = {{'A', 'Z'}, {'a', 'z'}};
  } else if (name == "L" || name == "IsAlphabetic") {
    set.ranges = {{'A', 'Z'},    {'a', 'z'},      {0xC0, 0xD6},    {0xD8, 0xF6},
                  {0xF8, 0x2FF}, {0x370, 0x1FFF}, {0x3040, 0xD7FF}};
  } else if (name == "Digit" || name == "Nd" || name == "N") {
    set.ranges = {{'0', '9'}};
  } else if (name == "Alnum") {
    set.ranges = {{'0', '9'}, {'A', 'Z'}, {'a', 'z'}};
  } else if (name == "Punct" || name == "P") {
    set.ranges = {{'!', '/'}, {':', '@'}, {'[', '`'}, {'{', '~'}};
  } else if (name == "Space") {
    set.ranges = {{'\t', '\r'}, {' ', ' '}};
  } else {
    return std::nullopt;
  }
  return set;
}

}  // namespace jaywalk::actions
