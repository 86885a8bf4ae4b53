// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/kills/kills_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "env/vehicle/defects.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/judge/csv_line.h"
#include "experiment/test_run/tested_vehicles.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

enum Column : std::size_t {
  kBehaviour,
  kAgents,
  kDefect,
  kSeverity,
  kTests,
  kKills,
  kShare,
  kLow,
  kHigh,
  kFirstMedian,
  kColumns,
};

class KillsParser {
 public:
  explicit KillsParser(SourcePtr source) : source_(std::move(source)) {}

  Result<std::vector<KillLine>> parse() {
    const std::string_view text = source_->text();
    bool header = true;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::string_view line = text.substr(begin, end - begin);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (header && line != kKillsCsvHeader) break;
      if (!header && !line.empty()) parse_line(line);
      header = false;
      begin = end + 1;
    }
    if (header) {
      error(text.substr(0, std::min(text.find('\n'), text.size())),
            fmt::format("expected the header '{}'", kKillsCsvHeader),
            "`jaywalk compare` and `jaywalk search` write such a file with --kills");
    }
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    return std::move(lines_);
  }

 private:
  void error(std::string_view where, std::string message, std::string hint = {}) {
    diagnostics_.error(span(where), std::move(message), std::move(hint));
  }

  [[nodiscard]] SourceSpan span(std::string_view where) const {
    const auto begin = static_cast<std::uint32_t>(where.data() - source_->text().data());
    return {source_, {begin, begin + static_cast<std::uint32_t>(where.size())}};
  }

  std::optional<std::uint64_t> number(const CsvField& field, std::uint64_t most) {
    std::uint64_t value = 0;
    const char* const end = field.text.data() + field.text.size();
    const auto [last, code] = std::from_chars(field.text.data(), end, value);
    if (code == std::errc() && last == end && value <= most) return value;
    error(field.where,
          fmt::format("expected a whole number up to {}, found '{}'", most, field.text));
    return std::nullopt;
  }

  void parse_line(std::string_view text) {
    const std::vector<CsvField> fields = csv_fields(text);
    if (fields.size() != kColumns) {
      error(text, fmt::format("expected {} fields, found {}", +kColumns, fields.size()));
      return;
    }
    const auto agents = number(fields[kAgents], UINT32_MAX);
    const auto tests = number(fields[kTests], kMaxTests);
    const auto kills = number(fields[kKills], tests.value_or(kMaxTests));
    const auto defect = read_defect_of(fields);
    const std::string& behaviour = fields[kBehaviour].text;
    if (!is_identifier(behaviour)) {
      error(fields[kBehaviour].where,
            fmt::format("'{}' cannot be the name of a behaviour", behaviour),
            std::string(kIdentifierHint));
      return;
    }
    std::optional<std::uint64_t> median;
    if (!fields[kFirstMedian].text.empty()) {
      median = number(fields[kFirstMedian], tests.value_or(kMaxTests));
      if (!median) return;
    }
    if (!agents || !tests || !kills || !defect) return;
    KillLine line{.behaviour = behaviour,
                  .agents = static_cast<std::uint32_t>(*agents),
                  .defect = *defect,
                  .tests = *tests,
                  .kills = *kills,
                  .first_median = median,
                  .where = span(text)};
    const auto same = [&](const KillLine& other) {
      return other.behaviour == line.behaviour && other.agents == line.agents &&
             other.defect == line.defect;
    };
    if (std::ranges::any_of(lines_, same)) {
      error(text, fmt::format("a second line for {} ({}) and {}", line.behaviour, line.agents,
                              line.defect));
    } else {
      lines_.push_back(std::move(line));
    }
  }

  std::optional<std::string> read_defect_of(const std::vector<CsvField>& fields) {
    const std::string& name = fields[kDefect].text;
    if (name == kGivenVehicle) return name;
    const std::string& severity = fields[kSeverity].text;
    const std::string text = severity.empty() ? name : fmt::format("{}={}", name, severity);
    if (const auto defect = parse_defect(text)) return text_of(*defect);
    std::vector<std::string> names;
    for (const DefectModel& model : defect_models()) names.emplace_back(model.name);
    error(fields[kDefect].where, fmt::format("unknown defect '{}'", text),
          did_you_mean(name, names));
    return std::nullopt;
  }

  SourcePtr source_;
  Diagnostics diagnostics_;
  std::vector<KillLine> lines_;
};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string fields_of(const KillCell& cell) {
  const auto tests = static_cast<double>(cell.tests);
  const ConfidenceInterval interval = wilson_interval(cell.kills, cell.tests);
  std::string text = fmt::format(",{},{}", cell.tests, cell.kills);
  add_csv_field(text, 100 * static_cast<double>(cell.kills) / tests);
  add_csv_field(text, 100 * interval.low);
  add_csv_field(text, 100 * interval.high);
  const auto median = first_kill_median(cell);
  return text + ',' + (median ? std::to_string(*median) : std::string());
}

}  // namespace

std::string to_kills_csv(const KillMatrix& matrix) {
  std::string text = fmt::format("{}\n", kKillsCsvHeader);
  for (const KillRow& row : matrix.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].tests == 0) continue;
      const std::string& defect = matrix.defects[i];
      const std::size_t end = std::min(defect.find('='), defect.size());
      const std::string severity = end < defect.size() ? defect.substr(end + 1) : "";
      text += fmt::format("{},{},{},{}{}\n", csv_quoted(row.behaviour), row.agents,
                          csv_quoted(defect.substr(0, end)), csv_quoted(severity),
                          fields_of(row.cells[i]));
    }
  }
  return text;
}

Result<std::vector<KillLine>> parse_kills(const SourcePtr& source) {
  return KillsParser(source).parse();
}

void add_kills(const std::vector<KillLine>& lines, KillMatrix& matrix) {
  for (const KillLine& line : lines) {
    const auto defect = std::ranges::find(matrix.defects, line.defect);
    if (defect == matrix.defects.end()) continue;
    auto row = std::ranges::find_if(matrix.rows, [&](const KillRow& each) {
      return each.kills_alone && each.behaviour == line.behaviour && each.agents == line.agents;
    });
    if (row == matrix.rows.end()) {
      matrix.rows.push_back({.behaviour = line.behaviour,
                             .agents = line.agents,
                             .cells = std::vector<KillCell>(matrix.defects.size()),
                             .kills_alone = true});
      row = matrix.rows.end() - 1;
    }
    KillCell& cell = row->cells[static_cast<std::size_t>(defect - matrix.defects.begin())];
    cell.tests = line.tests;
    cell.kills = line.kills;
    cell.measured = KillCell::Measured{line.first_median};
  }
}

Diagnostics mistakes_of(const std::vector<KillLine>& lines, const ExperimentPlan& plan,
                        const std::vector<KillLine>& earlier) {
  Diagnostics diagnostics;
  const KillLine* before = nullptr;
  for (const KillLine& line : lines) {
    const auto same_row = [&](const KillLine& other) {
      return other.behaviour == line.behaviour && other.agents == line.agents;
    };
    const bool planned = has(plan.behaviours, line.behaviour) &&
                         std::ranges::find(plan.agents, line.agents) != plan.agents.end();
    const bool reported = before != nullptr && same_row(*before);
    if (!reported && (planned || std::ranges::any_of(earlier, same_row))) {
      diagnostics.error(
          line.where,
          fmt::format("a second row {} ({}) beside the same one", line.behaviour, line.agents),
          planned ? "--behaviours and --agents leave out rows of the comparison" : "");
    }
    before = &line;
  }
  const bool none = std::ranges::none_of(
      lines, [&](const KillLine& line) { return has(plan.vehicles, line.defect); });
  if (none && !lines.empty()) {
    diagnostics.error(lines.front().where, "none of these defects is looked for here",
                      "--defects names those of both");
  }
  return diagnostics;
}

std::vector<std::string> other_defects(const std::vector<KillLine>& lines,
                                       const ExperimentPlan& plan) {
  std::vector<std::string> others;
  for (const KillLine& line : lines) {
    if (!has(plan.vehicles, line.defect) && !has(others, line.defect))
      others.push_back(line.defect);
  }
  return others;
}

}  // namespace jaywalk
