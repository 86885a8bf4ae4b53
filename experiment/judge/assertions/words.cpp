#include "experiment/judge/assertions/words.h"

#include <algorithm>
#include <array>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk::stl {
namespace {

constexpr std::array<std::string_view, 19> kReserved = {
    "and",          "or",    "not",   "implies", "always", "eventually", "once",
    "historically", "until", "since", "forall",  "exists", "true",       "false",
    "inf",          "abs",   "min",   "max",     "happens"};

}  // namespace

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_reserved(std::string_view word) {
  return std::find(kReserved.begin(), kReserved.end(), word) != kReserved.end();
}

std::string hint_for(std::string_view rest) {
  struct Habit {
    std::string_view sign;
    std::string_view hint;
  };
  static constexpr std::array kHabits = {
      Habit{"&&", "write 'and'"},
      Habit{"&", "write 'and'"},
      Habit{"||", "write 'or'"},
      Habit{"|", "write 'or'"},
      Habit{"!=", "compare two numbers, as in ttc != 0"},
      Habit{"!", "write 'not'"},
      Habit{"->", "write '=>'"},
      Habit{"==", "compare two numbers, as in ttc == 0"},
      Habit{"=>", "a condition stands on either side of '=>'"},
      Habit{"=", "write '=='"},
      Habit{"<", "write 'a < b and b < c'"},
      Habit{">", "write 'a > b and b > c'"},
      Habit{"until", "put 'p until q' into parentheses before it is combined further"},
      Habit{"since", "put 'p since q' into parentheses before it is combined further"},
  };
  for (const Habit& habit : kHabits) {
    if (rest.starts_with(habit.sign)) return std::string(habit.hint);
  }
  return {};
}

std::string keyword_hint(std::string_view before) {
  while (!before.empty() && !is_word_character(before.back())) before.remove_suffix(1);
  std::size_t begin = before.size();
  while (begin > 0 && is_word_character(before[begin - 1])) --begin;
  const std::string name(before.substr(begin));
  if (name.empty() || is_reserved(name)) return {};
  const std::vector<std::string> words(kReserved.begin(), kReserved.end());
  return did_you_mean(name, words);
}

}  // namespace jaywalk::stl
