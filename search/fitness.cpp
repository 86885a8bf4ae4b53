#include "search/fitness.h"

#include <algorithm>

namespace jaywalk::search {

std::optional<std::size_t> find_measure(std::span<const MeasureKind> measures,
                                        std::string_view name) {
  const auto found = std::ranges::find(measures, name, &MeasureKind::name);
  if (found == measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - measures.begin());
}

double Fitness::of(const Outcome& outcome) const {
  if (!outcome.executed() || measure >= outcome.measures.size()) return 0;
  return std::clamp((outcome.measures[measure] - harmless) / (worst - harmless), 0.0, 1.0);
}

}  // namespace jaywalk::search
