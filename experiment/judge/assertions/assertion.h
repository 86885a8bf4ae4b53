#pragma once

// Assertions: what the vehicle under test owes to those around it, when that is asked of it, and
// whether a recorded test shows that it kept it. docs/reference/assertions.md is the reference of
// the YAML files that hold them. Read expression.h and judge/signals/signals.h before.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/judge/assertions/expression.h"
#include "experiment/judge/signals/signals.h"
#include "interpreter/support/source_files.h"

namespace jaywalk {

enum class AssertionSeverity { minor, major, critical };

[[nodiscard]] std::string_view name(AssertionSeverity severity);

/// Immutable; shared by all threads.
struct Assertion {
  /// An atom, so that agents can believe it: `collision_avoidance`.
  std::string id;
  /// What it demands, in a sentence; may be empty.
  std::string summary;
  /// Where the rule comes from.
  std::string source;
  AssertionSeverity severity = AssertionSeverity::major;
  std::map<std::string, double> parameters;
  stl::Expression precondition;
  stl::Expression requirement;
  /// When a violation was unavoidable.
  std::optional<stl::Expression> unavoidable;

  /// It is judged for each road user by itself, as some of its expressions are about one.
  [[nodiscard]] bool is_about_one() const;
};

/// `vacuous`: the precondition was not met. `unavoidable`: the requirement was violated, but no
/// driver could have kept it.
enum class Verdict : std::uint8_t { vacuous, pass, fail, unavoidable };

inline constexpr std::size_t kVerdictCount = 4;

[[nodiscard]] std::string_view name(Verdict verdict);

/// What a test says about an assertion. Of road users judged by themselves the test's verdict is
/// the gravest: fail, then unavoidable, pass, vacuous.
struct Judgement {
  Verdict verdict = Verdict::vacuous;
  /// Of the requirement, the least of those for whom the precondition was met: 0 or less if it is
  /// violated. Empty if the verdict is vacuous.
  std::optional<double> robustness;
  /// No driver could have kept the requirement (for some road user), whether this AV did or not.
  bool excused = false;
  /// Of the precondition, the greatest: how near the test came to exercising the assertion.
  double exercised = 0;
  /// The first that violates the requirement; empty unless the verdict is fail or unavoidable.
  std::optional<std::uint32_t> tick;
  /// The road users who gave rise to the verdict; empty if it is vacuous or the assertion is about
  /// the AV alone.
  std::vector<ActorIndex> witnesses;

  friend bool operator==(const Judgement&, const Judgement&) = default;
};

[[nodiscard]] Judgement judge(const Assertion& assertion, const TestView& view);

/// Parses what a file holds. All mistakes are reported, with their places.
[[nodiscard]] Result<std::vector<Assertion>> parse_assertions(const SourcePtr& source);
[[nodiscard]] Result<std::vector<Assertion>> read_assertions(const std::string& path);

/// Assertions of several files, and their texts.
struct AssertionFiles {
  std::vector<Assertion> assertions;
  std::vector<SourcePtr> sources;
};

enum class SameId {
  /// Two files with one id are a mistake.
  refused,
  /// The later file's assertion takes the place of the earlier one's.
  replaced,
};

/// All files in their order, from the disk or from copies. All mistakes are reported.
[[nodiscard]] Result<AssertionFiles> read_assertion_files(const std::vector<std::string>& paths,
                                                          const SourceFiles& files = {},
                                                          SameId same_id = SameId::refused);

/// The names that expressions know: the rows of signals.def.
[[nodiscard]] const stl::Vocabulary& signal_vocabulary();

}  // namespace jaywalk
