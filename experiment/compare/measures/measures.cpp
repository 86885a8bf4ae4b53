#include "experiment/compare/measures/measures.h"

#include <algorithm>
#include <array>

namespace jaywalk {

std::span<const Measure> measures() {
  static constexpr std::array kMeasures = {
#define JAYWALK_MEASURE(name, column, low, high, summary) \
  Measure{#name, column, low, high, summary, &estimates::name},
#include "experiment/compare/measures/measures.def"
#undef JAYWALK_MEASURE
  };
  return kMeasures;
}

const Measure* find_measure(std::string_view name) {
  const auto found = std::ranges::find_if(measures(), [&](const Measure& measure) {
    return measure.name == name || measure.column == name;
  });
  return found == measures().end() ? nullptr : &*found;
}

}  // namespace jaywalk
