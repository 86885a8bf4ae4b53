// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "experiment/judge/csv_line.h"
#include "experiment/judge/situations/situations.h"

namespace jaywalk {
namespace {

/// Longer walks than any test has ticks.
constexpr std::size_t kMostMoves = 100'000;
constexpr std::uint64_t kMostCells = 1'000'000;

class ReachParser {
 public:
  explicit ReachParser(SourcePtr source) : source_(std::move(source)) {}

  Result<ReachFile> parse() {
    const std::string_view text = source_->text();
    bool has_header = false;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::string_view line = text.substr(begin, end - begin);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (!has_header && !parse_header(line)) return std::move(diagnostics_);
      if (has_header && !line.empty()) parse_line(line);
      has_header = true;
      begin = end + 1;
    }
    if (!has_header) (void)parse_header(text);
    if (!diagnostics_.has_errors()) check_completeness();
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    return std::move(file_);
  }

 private:
  void error(std::string_view where, std::string message, std::string hint = {}) {
    const auto begin = static_cast<std::uint32_t>(where.data() - source_->text().data());
    const Span span{begin, begin + static_cast<std::uint32_t>(where.size())};
    diagnostics_.error(SourceSpan{source_, span}, std::move(message), std::move(hint));
  }

  bool parse_header(std::string_view line) {
    if (line == kReachHeader) {
      for (const SituationItem& item : situation_items()) {
        file_.reachable.emplace_back(item.bins.size());
        read_.emplace_back(item.bins.size());
      }
      walk_ = 4;
    } else if (line != kWalksHeader) {
      error(line, fmt::format("expected the header '{}' or '{}'", kReachHeader, kWalksHeader),
            "`jaywalk reach` writes such a file with --csv");
      return false;
    }
    return true;
  }

  void parse_line(std::string_view line) {
    const std::vector<CsvField> fields = csv_fields(line);
    if (fields.size() != walk_ + 3) {
      error(line, fmt::format("expected {} fields, found {}", walk_ + 3, fields.size()));
      return;
    }
    if (walk_ > 0 && !parse_bin(fields)) return;
    parse_walk(fields[walk_], fields[walk_ + 1], fields[walk_ + 2]);
  }

  /// False if there is no walk to it, or after reporting a mistake.
  bool parse_bin(const std::vector<CsvField>& fields) {
    const auto items = situation_items();
    const auto item = std::ranges::find(items, fields[0].text, &SituationItem::name);
    if (item == items.end()) {
      error(fields[0].where, fmt::format("no situation is called '{}'", fields[0].text));
      return false;
    }
    const auto bin = number(fields[1], 1, item->bins.size());
    const auto reachable = number(fields[3], 0, 1);
    if (!bin || !reachable) return false;
    const auto index = static_cast<std::size_t>(item - items.begin());
    if (read_[index][*bin - 1]) {
      error(fields[0].where, fmt::format("a second line for bin {} of {}", *bin, item->name));
      return false;
    }
    read_[index][*bin - 1] = true;
    file_.reachable[index][*bin - 1] = *reachable == 1;
    return *reachable == 1;
  }

  /// A bin that a file cut short leaves out would count as one that no test can meet.
  void check_completeness() {
    for (std::size_t item = 0; item < read_.size(); ++item) {
      const auto missing = std::ranges::find(read_[item], false);
      if (missing == read_[item].end()) continue;
      diagnostics_.error(
          source_->name(),
          fmt::format("has no line for bin {} of {}", missing - read_[item].begin() + 1,
                      situation_items()[item].name),
          "`jaywalk reach` writes one for each bin, whether it can be met or not");
      return;
    }
  }

  void parse_walk(const CsvField& row, const CsvField& cell, const CsvField& moves) {
    const auto x = number(row, 0, kMostCells);
    const auto y = number(cell, 0, kMostCells);
    const bool known = moves.text.find_first_not_of(kWalkLetters) == std::string::npos;
    if (moves.text.empty() || !known || moves.text.size() > kMostMoves) {
      error(moves.where, fmt::format("expected up to {} letters of '{}', a step each", kMostMoves,
                                     kWalkLetters));
      return;
    }
    if (!x || !y) return;
    ScriptedWalk walk{{static_cast<int>(*x), static_cast<int>(*y)}, moves.text};
    if (std::ranges::find(file_.walks, walk) == file_.walks.end()) {
      file_.walks.push_back(std::move(walk));
    }
  }

  std::optional<std::uint64_t> number(const CsvField& field, std::uint64_t least,
                                      std::uint64_t most) {
    std::uint64_t value = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [last, code] = std::from_chars(field.text.data(), end, value);
    if (code == std::errc() && last == end && value >= least && value <= most) return value;
    error(field.where, fmt::format("expected a whole number from {} to {}, found '{}'", least, most,
                                   field.text));
    return std::nullopt;
  }

  SourcePtr source_;
  Diagnostics diagnostics_;
  ReachFile file_;
  /// The bins that had a line; empty if the file has walks alone.
  ReachableBins read_;
  /// The index of a walk's first field.
  std::size_t walk_ = 0;
};

}  // namespace

Result<ReachFile> parse_reach_file(const SourcePtr& source) { return ReachParser(source).parse(); }

}  // namespace jaywalk
