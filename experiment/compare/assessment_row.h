#pragma once

// A result about one test, as stores keep it: the value of a metric or the verdict of an assertion.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace jaywalk {

/// `none`: a metric, which has a value and no verdict.
enum class StoredVerdict { none, vacuous, pass, fail, unavoidable };

/// `none`, `vacuous`, `pass`, `fail`, `unavoidable`: the words of the store's column.
[[nodiscard]] std::string_view name(StoredVerdict verdict);
[[nodiscard]] std::optional<StoredVerdict> parse_stored_verdict(std::string_view text);

/// One row of the table `assessments`. Numbers may be infinite but not NaN.
struct AssessmentRow {
  /// The id of the metric or assertion, `min_distance`; unique in its test together with the actor.
  std::string id;
  std::optional<double> value;
  /// The tick that the value belongs to, or the first one that violates the assertion.
  std::optional<std::uint32_t> tick;
  /// Index into the recording's actors: the other road user, if it concerns one.
  std::optional<std::uint32_t> actor;
  std::optional<double> robustness;
  StoredVerdict verdict = StoredVerdict::none;

  friend bool operator==(const AssessmentRow&, const AssessmentRow&) = default;
};

}  // namespace jaywalk
