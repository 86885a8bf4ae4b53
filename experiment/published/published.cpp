#include "experiment/published/published.h"

#include <charconv>
#include <map>
#include <tuple>

#include "experiment/published/paper_figures.h"

namespace jaywalk {
namespace {

using Key = std::tuple<std::string_view, std::string_view, std::uint32_t>;
using Figures = std::map<Key, Estimate>;

/// The text up to the separator, which is removed from `rest` with it.
std::string_view take(std::string_view& rest, char separator) {
  const auto end = rest.find(separator);
  const std::string_view taken = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return taken;
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Figures parse(std::string_view text) {
  Figures figures;
  while (!text.empty()) {
    std::string_view line = take(text, '\n');
    if (line.starts_with('#')) continue;
    const std::string_view column = take(line, ',');
    const std::string_view behaviour = take(line, ',');
    const auto agents = number(take(line, ','));
    if (!agents) continue;  // the line with the names of the columns
    Estimate figure;
    figure.value = number(take(line, ','));
    figure.low = number(take(line, ','));
    figure.high = number(take(line, ','));
    figures[{column, behaviour, static_cast<std::uint32_t>(*agents)}] = figure;
  }
  return figures;
}

}  // namespace

std::optional<Estimate> published_figure(const Measure& measure, std::string_view behaviour,
                                         std::uint32_t agents) {
  static const Figures kFigures = parse(kPaperFigures);
  const auto found = kFigures.find({measure.column, behaviour, agents});
  if (found == kFigures.end()) return std::nullopt;
  return found->second;
}

}  // namespace jaywalk
