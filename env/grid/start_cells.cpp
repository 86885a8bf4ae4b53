// SPDX-License-Identifier: Apache-2.0
#include "env/grid/start_cells.h"

#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace jaywalk {
namespace {

constexpr std::string_view kHeader = "test,agent,row,cell";
constexpr std::size_t kColumns = 4;

class StartCellsParser {
 public:
  StartCellsParser(const SourcePtr& source, const Grid& grid) : source_(source), grid_(grid) {}

  Result<StartCells> parse() {
    const std::string_view text = source_->text();
    bool header = true;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::string_view line = text.substr(begin, end - begin);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (!line.empty()) {
        if (header && line != kHeader) {
          error(line, "expected the header 'test,agent,row,cell'");
          return std::move(diagnostics_);
        }
        if (!header) parse_row(line);
        header = false;
      }
      begin = end + 1;
    }
    if (header) diagnostics_.error(source_->name(), "expected the header 'test,agent,row,cell'");
    return finish();
  }

 private:
  void error(std::string_view where, std::string message) {
    const auto begin = static_cast<std::uint32_t>(where.data() - source_->text().data());
    const Span span{begin, begin + static_cast<std::uint32_t>(where.size())};
    diagnostics_.error(SourceSpan{source_, span}, std::move(message));
  }

  std::optional<std::uint64_t> number(std::string_view field) {
    std::uint64_t value = 0;
    const auto [end, code] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (code == std::errc() && end == field.data() + field.size()) return value;
    error(field, fmt::format("expected a whole number from 0 to {}, found '{}'",
                             std::numeric_limits<std::uint64_t>::max(), field));
    return std::nullopt;
  }

  void parse_row(std::string_view line) {
    std::array<std::uint64_t, kColumns> values{};
    std::size_t column = 0;
    for (std::string_view rest = line;; ++column) {
      const std::size_t comma = rest.find(',');
      const bool last = comma == std::string_view::npos;
      if (column == kColumns || (last && column + 1 < kColumns)) {
        error(line, "expected four numbers: test,agent,row,cell");
        return;
      }
      const std::optional<std::uint64_t> value = number(rest.substr(0, comma));
      if (!value) return;
      values[column] = *value;
      if (last) break;
      rest.remove_prefix(comma + 1);
    }
    add(line, values);
  }

  void add(std::string_view line, const std::array<std::uint64_t, kColumns>& values) {
    const auto [test, agent, row, cell] = values;
    if (row >= static_cast<std::uint64_t>(grid_.rows) ||
        cell >= static_cast<std::uint64_t>(grid_.cells)) {
      error(line, fmt::format("row {}, cell {} does not lie on the grid of {} rows and {} cells",
                              row, cell, grid_.rows, grid_.cells));
      return;
    }
    if (agent == 0) {
      error(line, "agents are numbered from 1");
      return;
    }
    const Position position{static_cast<int>(row), static_cast<int>(cell)};
    if (!agents_[test].emplace(agent, position).second) {
      error(line, fmt::format("agent {} of test {} has a start cell already", agent, test));
    }
  }

  Result<StartCells> finish() {
    StartCells result;
    for (const auto& [test, agents] : agents_) {
      for (const auto& [agent, position] : agents) {
        std::vector<Position>& cells = result[test];
        cells.push_back(position);
        if (agent != cells.size()) {
          diagnostics_.error(source_->name(), fmt::format("test {} has agent {} but no agent {}",
                                                          test, agent, cells.size()));
          break;
        }
      }
    }
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    return result;
  }

  const SourcePtr& source_;
  const Grid& grid_;
  Diagnostics diagnostics_;
  std::map<std::uint64_t, std::map<std::uint64_t, Position>> agents_;
};

}  // namespace

Result<StartCells> parse_start_cells(const SourcePtr& source, const Grid& grid) {
  return StartCellsParser(source, grid).parse();
}

std::string print_start_cells(const StartCells& cells) {
  std::string text(kHeader);
  text += '\n';
  for (const auto& [test, positions] : cells) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      text += fmt::format("{},{},{},{}\n", test, i + 1, positions[i].x, positions[i].y);
    }
  }
  return text;
}

}  // namespace jaywalk
