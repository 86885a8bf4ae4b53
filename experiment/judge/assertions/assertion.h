// SPDX-License-Identifier: Apache-2.0
#pragma once

// Assertions: requirements on the vehicle under test, the preconditions under which they apply, and
// the verdict for a recorded test. docs/reference/assertions.md is the reference of the YAML
// files that hold them. Read expression.h and judge/signals/signals.h first.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/judge/assertions/expression.h"
#include "experiment/judge/signals/signals.h"
#include "interpreter/support/source_files.h"
#include <jaywalk/judge.h>

namespace jaywalk {

/// Immutable; shared by all threads.
struct Assertion {
  /// An atom, so that agents can believe it: `collision_avoidance`.
  std::string id;
  /// The requirement in a sentence; may be empty.
  std::string summary;
  /// The source of the rule, such as a law or standard.
  std::string source;
  AssertionSeverity severity = AssertionSeverity::major;
  std::map<std::string, double> parameters;
  stl::Expression precondition;
  stl::Expression requirement;
  /// The condition under which a violation was unavoidable.
  std::optional<stl::Expression> unavoidable;

  /// Whether it is judged for each road user separately, because some of its expressions are about
  /// one.
  [[nodiscard]] bool is_about_one() const;
};

/// The verdict of an assertion for a test. If road users are judged one by one, the test has the
/// gravest of their verdicts: fail, then unavoidable, pass, vacuous.
struct Judgement {
  Verdict verdict = Verdict::vacuous;
  /// The robustness of the requirement, the least over the road users with a met precondition: 0 or
  /// less if it is violated. Empty if the verdict is vacuous.
  std::optional<double> robustness;
  /// No driver could have kept the requirement (for some road user), whether this AV did or not.
  bool excused = false;
  /// The greatest robustness of the precondition: how near the test came to exercising the
  /// assertion.
  double exercised = 0;
  /// The first tick that violates the requirement; empty unless the verdict is fail or unavoidable.
  std::optional<std::uint32_t> tick;
  /// The road users with this verdict; empty if it is vacuous or the assertion is about the AV
  /// alone.
  std::vector<ActorIndex> witnesses;

  friend bool operator==(const Judgement&, const Judgement&) = default;
};

[[nodiscard]] Judgement judge(const Assertion& assertion, const TestView& view);

/// Parses the text of a file. All errors are reported, with their places.
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
  /// The later file's assertion replaces the earlier one's.
  replaced,
};

/// All files in their order, from the disk or from copies. All mistakes are reported.
[[nodiscard]] Result<AssertionFiles> read_assertion_files(const std::vector<std::string>& paths,
                                                          const SourceFiles& files = {},
                                                          SameId same_id = SameId::refused);

/// The names that expressions know: the rows of signals.def.
[[nodiscard]] const stl::Vocabulary& signal_vocabulary();

}  // namespace jaywalk
