// SPDX-License-Identifier: Apache-2.0
#pragma once

// The properties of internal actions in their table, for code that reads programs without running
// them: the checker, editors, the system that lets agents reason in parallel. The words of the
// table's columns are in the namespace action_words.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace jaywalk {

/// How an action takes its arguments.
struct ActionKind {
  bool body_only = false;
  bool raw_args = false;
  /// Bit i: argument i is a formula.
  std::uint32_t formula_args = 0;
  bool is_uncounted = false;
};

/// The meaning of its arguments, the first one unless said otherwise.
enum class About : std::uint8_t {
  anything,
  goal,
  belief,
  new_belief,   ///< one that is added
  new_plans,    ///< a plan, or a text that is one
  new_program,  ///< beliefs, goals and plans of a file
  message,      ///< the content of a message, after its performative
  agents,       ///< others of the system
};

/// Properties of an action. The defaults are those of an unknown action: it may give any variable a
/// value.
struct ActionTraits {
  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

  /// Whether it may give variables in its arguments a value; false is certain.
  bool binds = true;
  /// Whether it always fails.
  bool fails = false;
  bool removes_plans = false;
  About about = About::anything;
  /// For messages: the index of the argument with the performative; the content follows it.
  std::size_t performative = 0;
  /// From this number of arguments on, other agents can notice it within the same round.
  std::size_t far_from = kNever;
  /// The least and the greatest number of arguments with which it may suspend the intention.
  std::size_t waits_from = kNever;
  std::size_t waits_to = 0;

  [[nodiscard]] constexpr bool is_far(std::size_t arguments) const { return arguments >= far_from; }
  [[nodiscard]] constexpr bool waits_with(std::size_t arguments) const {
    return arguments >= waits_from && arguments <= waits_to;
  }
  [[nodiscard]] constexpr bool is_about_belief() const {
    return about == About::belief || about == About::new_belief;
  }
  /// Whether a program that uses it expects other agents.
  [[nodiscard]] constexpr bool is_social() const {
    return about == About::message || about == About::agents;
  }
};

namespace action_words {

// Kinds.
inline constexpr ActionKind plain{};
inline constexpr ActionKind body_only{.body_only = true};
inline constexpr ActionKind raw{.raw_args = true};
inline constexpr ActionKind uncounted{.is_uncounted = true};
constexpr ActionKind query(unsigned argument) {
  return {.raw_args = true, .formula_args = 1U << argument};
}

// Traits: one of the first two, then what else is so.
inline constexpr ActionTraits reads{.binds = false};
inline constexpr ActionTraits binds{};
inline constexpr ActionTraits far{.binds = false, .far_from = 0};
constexpr ActionTraits far_from(std::size_t arguments) {
  return {.binds = false, .far_from = arguments};
}
inline constexpr ActionTraits fails{.binds = false, .fails = true};
inline constexpr ActionTraits removes_plans{.binds = false, .removes_plans = true};
inline constexpr ActionTraits about_goal{.binds = false, .about = About::goal};
inline constexpr ActionTraits about_belief{.binds = false, .about = About::belief};
inline constexpr ActionTraits about_agents{.binds = false, .about = About::agents};
inline constexpr ActionTraits adds_belief{.binds = false, .about = About::new_belief};
inline constexpr ActionTraits adds_plans{.binds = false, .about = About::new_plans};
inline constexpr ActionTraits adds_program{.binds = false, .about = About::new_program};
constexpr ActionTraits message(std::size_t performative) {
  return {.binds = false, .about = About::message, .performative = performative};
}
constexpr ActionTraits waits(std::size_t least, std::size_t most) {
  return {.binds = false, .waits_from = least, .waits_to = most};
}

constexpr ActionTraits operator|(ActionTraits a, const ActionTraits& b) {
  if (a.about == About::anything) a.about = b.about;
  return {.binds = a.binds || b.binds,
          .fails = a.fails || b.fails,
          .removes_plans = a.removes_plans || b.removes_plans,
          .about = a.about,
          .performative = std::max(a.performative, b.performative),
          .far_from = std::min(a.far_from, b.far_from),
          .waits_from = std::min(a.waits_from, b.waits_from),
          .waits_to = std::max(a.waits_to, b.waits_to)};
}

}  // namespace action_words

/// A row of the table.
struct ActionRow {
  /// With its dot: ".print".
  std::string_view name;
  /// -1: any number.
  int most = 0;
  ActionKind kind;
  ActionTraits traits;
};

inline constexpr auto kActionRows = [] {
  using namespace action_words;
  constexpr auto row = [](std::string_view signature, int most, ActionKind kind,
                          const ActionTraits& traits) {
    return ActionRow{signature.substr(0, signature.find('(')), most, kind, traits};
  };
#define JAYWALK_ACTION(function, least, most, kind, traits, signature, summary) \
  row(signature, most, kind, traits),
  return std::array{
#include "interpreter/actions/table/actions.def"
  };
#undef JAYWALK_ACTION
}();

/// The row of that name, or null.
[[nodiscard]] constexpr const ActionRow* find_action_row(std::string_view name) {
  if (!name.starts_with('.')) return nullptr;
  const auto* const found = std::ranges::find(kActionRows, name, &ActionRow::name);
  return found == kActionRows.end() ? nullptr : found;
}

/// The properties of the action of that name, or the defaults if there is none.
[[nodiscard]] constexpr ActionTraits traits_of(std::string_view name) {
  const ActionRow* const row = find_action_row(name);
  return row == nullptr ? ActionTraits{} : row->traits;
}

/// The index of the argument that is a query, given the number of arguments; kNever: none is. A
/// query that is not the first argument is there only if all arguments are: `.max(List, X)` has
/// none, `.max(Term, Query, X)` has one.
[[nodiscard]] constexpr std::size_t query_index(std::string_view name, std::size_t arguments) {
  const ActionRow* const row = find_action_row(name);
  if (row == nullptr || row->kind.formula_args == 0) return ActionTraits::kNever;
  const bool is_first = row->kind.formula_args == 1;
  if (arguments == 0 || (!is_first && arguments != static_cast<std::size_t>(row->most))) {
    return ActionTraits::kNever;
  }
  std::size_t index = 0;
  while ((row->kind.formula_args >> index & 1U) == 0) ++index;
  return index;
}

}  // namespace jaywalk
