// SPDX-License-Identifier: Apache-2.0
#include "search/sut.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace jaywalk::search {

std::string why_nonsense(const Outcome& outcome, std::string_view time,
                         const std::vector<std::string>& measures) {
  // Sums of greater numbers would be infinite.
  constexpr double kLongestTest_s = 31'536'000;  // a year
  constexpr double kGreatestMeasure = 1e12;
  if (!(outcome.simulated_s >= 0)) return fmt::format("{} is not a number of seconds", time);
  if (outcome.simulated_s > kLongestTest_s) {
    return fmt::format("a test of more than {:g} s", kLongestTest_s);
  }
  for (std::size_t i = 0; i < outcome.measures.size(); ++i) {
    const double measure = outcome.measures[i];
    if (!std::isfinite(measure)) return fmt::format("'{}' is not a number", measures[i]);
    if (std::fabs(measure) > kGreatestMeasure) {
      return fmt::format("'{}' is beyond {:g}", measures[i], kGreatestMeasure);
    }
  }
  return {};
}

std::optional<std::size_t> find_measure(std::span<const MeasureKind> measures,
                                        std::string_view name) {
  const auto found = std::ranges::find(measures, name, &MeasureKind::name);
  if (found == measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - measures.begin());
}

std::vector<std::size_t> requirements_of(std::span<const MeasureKind> measures) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (!measures[i].requirement.empty()) found.push_back(i);
  }
  return found;
}

double Fitness::of(const Outcome& outcome) const {
  if (!outcome.executed() || measure >= outcome.measures.size()) return 0;
  return std::clamp((outcome.measures[measure] - harmless) / (worst - harmless), 0.0, 1.0);
}

std::vector<std::string> situation_measures() {
  std::vector<std::string> names;
  for (const SituationItem& item : situation_items()) {
    names.push_back(fmt::format("bin_{}", item.name));
  }
  return names;
}

void add_situations(const SituationBins& bins, std::vector<double>& measures) {
  for (const auto& bin : bins) measures.push_back(bin ? *bin + 1.0 : 0.0);
}

std::optional<SituationBins> situation_bins(const Outcome& outcome,
                                            std::span<const MeasureKind> measures) {
  static const std::string kFirst = situation_measures().front();
  const auto first = find_measure(measures, kFirst);
  if (!first) return std::nullopt;
  SituationBins bins(situation_items().size());
  for (std::size_t i = 0; i < bins.size() && outcome.executed(); ++i) {
    const double bin = outcome.measures[*first + i];
    if (bin > 0) bins[i] = static_cast<std::uint32_t>(bin) - 1;
  }
  return bins;
}

}  // namespace jaywalk::search
