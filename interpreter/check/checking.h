// SPDX-License-Identifier: Apache-2.0
#pragma once

// The input of every check of checks.def: the program, what is known of its names, and the
// functions that report warnings.

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/check/check.h"
#include "interpreter/check/index/program_index.h"
#include "interpreter/check/index/uses.h"
#include "interpreter/support/containers/lazy.h"

namespace jaywalk {

struct CheckedFile {
  const ast::File* file = nullptr;
  Uses uses;
  /// Whether it is the program itself, not an included file.
  bool is_main = false;
  /// Codes that a comment silences in the whole file.
  std::set<std::string, std::less<>> allowed;
  /// Names that a program which includes the file must define, as `radius/1` or `!cross/0`.
  std::set<std::string_view> asked;
  /// The reported warnings, by place and code, so that each is reported once.
  std::set<std::pair<std::uint32_t, std::string_view>> reported;
  Diagnostics found;
};

class Checking {
 public:
  Checking(const SourceTree& program, ProgramWords words, const Vocabulary& vocabulary);

  [[nodiscard]] const SourceTree& program() const { return program_; }
  [[nodiscard]] const Vocabulary& vocabulary() const { return vocabulary_; }
  [[nodiscard]] const ProgramIndex& index() const { return index_; }
  [[nodiscard]] const Mentions& mentions() const { return *mentions_; }
  /// Names that can answer a query: beliefs, percepts and plans for test goals.
  [[nodiscard]] const NameSet& answers() const { return answers_; }
  [[nodiscard]] std::vector<CheckedFile>& files() { return files_; }

  /// Whether its beliefs come from the program itself and its known environment alone.
  [[nodiscard]] bool told_everything() const {
    return vocabulary_.environment_known && !index_.sends_messages;
  }
  /// Whether no unknown agent posts goals to the agent or asks it: the other agents are known, or
  /// the program has its own goals and does not mention other agents.
  [[nodiscard]] bool asked_by_nobody() const;
  [[nodiscard]] bool has_initial_goal() const { return has_initial_goal_; }
  /// Whether plans or goals may come from where the checker cannot look.
  [[nodiscard]] bool may_be_told_plans() const {
    return index_.has_open_goals || vocabulary_.named_by_others.contains("tellHow");
  }
  /// Whether the program, or another agent, mentions the name where it may use it.
  [[nodiscard]] bool is_mentioned(std::string_view name) const;
  /// A hint to include the installed library that defines a name, or that asks its includer for it
  /// (`radius/1`, `!cross/0`); empty: there is none.
  [[nodiscard]] std::string library_defining(std::string_view name) const;
  [[nodiscard]] std::string library_asking(std::string_view name) const;

  /// From here on, warnings have that code.
  void begin(std::string_view code) { code_ = code; }
  void warn(CheckedFile& file, Span where, std::string message, std::string hint = {});
  void warn(const Vocabulary::Setting& setting, std::string message, std::string hint = {});
  /// Whether further warnings are only counted, so that no hints need be looked for.
  [[nodiscard]] static bool is_full(const CheckedFile& file) {
    return file.found.items().size() >= Diagnostics::kLimit;
  }
  /// All that was found, by file and place.
  [[nodiscard]] Diagnostics finish();

 private:
  const SourceTree& program_;
  const Vocabulary& vocabulary_;
  ProgramIndex index_;
  Lazy<Mentions> mentions_;
  Lazy<bool> has_other_agents_;
  Lazy<std::vector<Vocabulary::Library>> libraries_;
  NameSet answers_;
  std::vector<CheckedFile> files_;
  Diagnostics about_settings_;
  bool has_initial_goal_ = false;
  std::string_view code_;
};

#define JAYWALK_CHECK(function, code, summary) void function(Checking& checking);
#include "interpreter/check/checks.def"

/// Whether one name is likely a slip for the other: long enough, and not distinguished on purpose
/// as `left1` and `left2` are, `pos_x` and `pos_y`, `bid` and `bids`.
[[nodiscard]] bool is_misspelling(std::string_view name, std::string_view meant);

/// Whether one word becomes the other by one letter more, less or changed, or by two neighbours
/// that change places: a Damerau-Levenshtein distance of 1.
[[nodiscard]] bool is_one_slip(std::string_view a, std::string_view b);

/// "1 or 2 arguments"
[[nodiscard]] std::string counted(const std::set<int>& arities);
[[nodiscard]] std::string counted(const Vocabulary::Entry& entry);

/// The first entry of that name, or null.
/// `.print` for `jason.stdlib.print`; other names as they are.
[[nodiscard]] std::string_view short_name(std::string_view action);
[[nodiscard]] const Vocabulary::Entry* entry_of(std::span<const Vocabulary::Entry> entries,
                                                std::string_view name);
[[nodiscard]] bool takes(const Vocabulary::Entry& entry, int arity);
[[nodiscard]] std::vector<std::string> names_of(std::span<const Vocabulary::Entry> entries);

}  // namespace jaywalk
