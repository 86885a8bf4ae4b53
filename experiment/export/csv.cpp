#include "experiment/export/csv.h"

#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "experiment/measures/measures.h"

namespace jaywalk {
namespace {

std::string decimal(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

void add_field(std::string& line, std::optional<double> value) {
  line += ',';
  if (value) line += decimal(*value);
}

/// A name as a field: in quotes if it holds a separator.
std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

}  // namespace

std::string to_csv(const Comparison& comparison) {
  std::string text = "behaviour,agents,tests,successes";
  for (const Measure& measure : measures()) {
    for (const auto column : {measure.column, measure.low_column, measure.high_column}) {
      if (!column.empty()) text += fmt::format(",{}", column);
    }
  }
  text += '\n';
  for (const Summary& summary : comparison.summaries) {
    text += fmt::format("{},{},{},{}", quoted(summary.behaviour), summary.agents, summary.tests,
                        summary.successes);
    for (const Measure& measure : measures()) {
      const Estimate estimate = measure.estimate(summary);
      add_field(text, estimate.value);
      if (!measure.low_column.empty()) add_field(text, estimate.low);
      if (!measure.high_column.empty()) add_field(text, estimate.high);
    }
    text += '\n';
  }
  return text;
}

}  // namespace jaywalk
