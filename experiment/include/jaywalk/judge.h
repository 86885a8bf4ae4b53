// SPDX-License-Identifier: Apache-2.0
#pragma once

// How tests are judged: by assertions, requirements on the vehicle under test that YAML files list
// (docs/reference/assertions.md), and by metrics (docs/reference/measures.md).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <jaywalk/diagnostics.h>

namespace jaywalk {

struct Assertion;
struct Criteria;

enum class AssertionSeverity { minor, major, critical };

/// `vacuous`: the precondition was not met. `unavoidable`: the requirement was violated, but no
/// driver could have kept it.
enum class Verdict : std::uint8_t { vacuous, pass, fail, unavoidable };
inline constexpr std::size_t kVerdictCount = 4;

/// "major", "unavoidable": the words of files and tables.
[[nodiscard]] std::string_view name(AssertionSeverity severity);
[[nodiscard]] std::string_view name(Verdict verdict);

struct AssertionInfo {
  std::string id;
  /// The requirement in a sentence, and the law or standard that it is from; may be empty.
  std::string summary;
  std::string source;
  AssertionSeverity severity = AssertionSeverity::major;
};

/// Assertions, and whether metrics are taken as well. Immutable; may be shared by threads.
class JudgingRules {
 public:
  /// None: nothing is judged.
  JudgingRules();
  /// The assertions of these files, in their order. Errors have their places in the files; two
  /// files with one id are one, too.
  [[nodiscard]] static Result<JudgingRules> read(const std::vector<std::string>& paths);
  explicit JudgingRules(std::shared_ptr<const Criteria> criteria);

  /// These rules with or without metrics.
  [[nodiscard]] JudgingRules with_metrics(bool measured) const;
  [[nodiscard]] std::vector<AssertionInfo> assertions() const;
  [[nodiscard]] const Criteria& criteria() const { return *criteria_; }

 private:
  std::shared_ptr<const Criteria> criteria_;
};

/// The verdict of one assertion for one test. If road users are judged one by one, the test has the
/// gravest of their verdicts.
struct TestVerdict {
  std::string assertion;
  Verdict verdict = Verdict::vacuous;
  /// By how much the requirement was kept, in its own units; 0 or less if it was violated. Empty if
  /// the verdict is vacuous.
  std::optional<double> robustness;
  /// The first tick that violates the requirement, if one does.
  std::optional<std::uint32_t> tick;
};

struct MetricReading {
  std::string_view metric;  // "min_distance"
  std::string_view unit;    // "m"
  /// Empty if it does not exist in this test (no collision course, say); may be infinite.
  std::optional<double> value;
};

}  // namespace jaywalk
