#include "experiment/compare/kills/kills_csv.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "experiment/compare/csv_fields.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/judge/csv_line.h"

namespace jaywalk {
namespace {

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

}  // namespace jaywalk
