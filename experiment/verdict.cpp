#include "experiment/verdict.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiment/trimmed.h"

namespace jaywalk {
namespace {

/// Longer operators before those that they begin with.
constexpr std::array<std::pair<std::string_view, BoundKind>, 6> kBoundKinds = {{
    {"<=", BoundKind::less_equal},
    {">=", BoundKind::greater_equal},
    {"==", BoundKind::equal},
    {"!=", BoundKind::not_equal},
    {"<", BoundKind::less},
    {">", BoundKind::greater},
}};

Diagnostics refusal(std::string message, std::string hint) {
  Diagnostics diagnostics;
  diagnostics.error("--fail-on", std::move(message), std::move(hint));
  return diagnostics;
}

bool holds(double value, BoundKind kind, double bound) {
  switch (kind) {
    case BoundKind::less:
      return value < bound;
    case BoundKind::less_equal:
      return value <= bound;
    case BoundKind::greater:
      return value > bound;
    case BoundKind::greater_equal:
      return value >= bound;
    case BoundKind::equal:
      return value == bound;
    case BoundKind::not_equal:
      return value != bound;
  }
  std::abort();
}

}  // namespace

Result<FailureCondition> parse_failure_condition(std::string_view text) {
  const auto at = text.find_first_of("<>=!");
  const std::string name(trimmed(text.substr(0, at)));
  FailureCondition condition{.text = std::string(trimmed(text))};
  std::string_view number;
  bool compared = false;
  for (const auto& [sign, kind] : kBoundKinds) {
    if (at == std::string_view::npos || !text.substr(at).starts_with(sign)) continue;
    condition.kind = kind;
    number = trimmed(text.substr(at + sign.size()));
    compared = true;
    break;
  }
  if (!compared) {
    return refusal(fmt::format("expected a measure, a comparison and a number, found '{}'", text),
                   "write it as 'accuracy<40'");
  }
  condition.measure = find_measure(name);
  if (condition.measure == nullptr) {
    std::vector<std::string> known;
    for (const Measure& measure : measures()) known.emplace_back(measure.name);
    std::string hint = did_you_mean(name, known);
    if (hint.empty()) hint = "jaywalk list measures names them";
    return refusal(fmt::format("unknown measure '{}'", name), std::move(hint));
  }
  const char* const number_end = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), number_end, condition.bound);
  if (error != std::errc{} || end != number_end || !std::isfinite(condition.bound)) {
    return refusal(fmt::format("expected a number after '{}', found '{}'", name, number), {});
  }
  return condition;
}

bool fails(const FailureCondition& condition, const Summary& summary) {
  const Estimate estimate = condition.measure->estimate(summary);
  return estimate.value && holds(*estimate.value, condition.kind, condition.bound);
}

}  // namespace jaywalk
