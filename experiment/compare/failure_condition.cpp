// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/failure_condition.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/support/text.h"

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

/// The fields of an assertion in conditions: the verdicts, in their order, and the share of tests.
constexpr std::array<std::string_view, kVerdictCount + 1> kFields = {
    "vacuous", "pass", "fail", "unavoidable", "exercised_pct"};

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
  const auto dot = name.find('.');
  condition.measure = find_measure(name);
  if (dot != std::string::npos) {
    condition.assertion = name.substr(0, dot);
    condition.field = name.substr(dot + 1);
    if (std::ranges::find(kFields, condition.field) == kFields.end()) {
      const std::vector<std::string> fields(kFields.begin(), kFields.end());
      std::string hint = did_you_mean(condition.field, fields);
      if (hint.empty()) hint = fmt::format("expected {}", fmt::join(kFields, ", "));
      return refusal(fmt::format("unknown verdict '{}'", condition.field), std::move(hint));
    }
  } else if (condition.measure == nullptr) {
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

std::string subject_of(const FailureCondition& condition) {
  if (condition.measure != nullptr) return std::string(condition.measure->name);
  return fmt::format("{}.{}", condition.assertion, condition.field);
}

std::optional<double> value_of(const FailureCondition& condition, const Comparison& comparison,
                               std::size_t row) {
  if (condition.measure != nullptr) {
    return condition.measure->estimate(comparison.summaries[row]).value;
  }
  const auto assertion = std::ranges::find(comparison.assertions, condition.assertion);
  if (assertion == comparison.assertions.end() || comparison.assessments.empty())
    return std::nullopt;
  const auto index = static_cast<std::size_t>(assertion - comparison.assertions.begin());
  const VerdictCounts& counts = comparison.assessments[row].verdicts[index];
  if (counts.all() == 0) return std::nullopt;
  const auto field = std::ranges::find(kFields, condition.field) - kFields.begin();
  if (static_cast<std::size_t>(field) == kVerdictCount) return exercised_pct(counts);
  return static_cast<double>(counts.of(static_cast<Verdict>(field)));
}

Diagnostics problems(const FailureCondition& condition, std::span<const Assertion> assertions) {
  if (condition.measure != nullptr) return {};
  std::vector<std::string> ids;
  for (const Assertion& assertion : assertions) ids.push_back(assertion.id);
  if (std::ranges::find(ids, condition.assertion) != ids.end()) return {};
  std::string hint = did_you_mean(condition.assertion, ids);
  if (hint.empty() && ids.empty()) hint = "--assertions names a file of assertions to judge";
  return refusal(fmt::format("no assertion '{}' is judged", condition.assertion), std::move(hint));
}

bool fails(const FailureCondition& condition, const Comparison& comparison, std::size_t row) {
  const auto value = value_of(condition, comparison, row);
  return !value || holds(*value, condition.kind, condition.bound);
}

}  // namespace jaywalk
