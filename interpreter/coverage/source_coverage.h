// SPDX-License-Identifier: Apache-2.0
#pragma once

// Coverage at the places in the source: what of each file's plans, rules, conditions and formulas
// was used, and how often. Made of the counts of one set of programs; reports of several are put
// together by place, so that a file that many programs include is counted as one.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "interpreter/coverage/coverage.h"
#include "interpreter/support/source_files.h"
#include <jaywalk/diagnostics.h>

namespace jaywalk {

/// A stretch of text, as lines from 1 and columns from 1, both inclusive.
struct CoveredPlace {
  std::uint32_t line = 0;
  std::uint32_t column = 1;
  std::uint32_t last_line = 0;
  std::uint32_t last_column = 1;

  friend auto operator<=>(const CoveredPlace&, const CoveredPlace&) = default;
};

struct CoveredCondition {
  CoveredPlace where;
  std::string text;
  ConditionCounts counts;

  [[nodiscard]] std::uint64_t failed() const { return counts.asked - counts.held; }
};

struct CoveredFormula {
  CoveredPlace where;
  std::string text;
  FormulaCounts counts;
};

struct CoveredPlan {
  CoveredPlace where;
  /// "+!cross(X)", as written.
  std::string trigger;
  PlanCounts counts;
  std::vector<CoveredCondition> conditions;
  std::vector<CoveredFormula> formulas;
};

struct CoveredRule {
  CoveredPlace where;
  /// The head, as written.
  std::string head;
  std::vector<CoveredCondition> conditions;
};

/// How much of a kind there is and how much was covered.
struct Share {
  std::uint64_t covered = 0;
  std::uint64_t of = 0;

  void add(const Share& other) {
    covered += other.covered;
    of += other.of;
  }
};

/// Plans that were chosen; outcomes of conditions (each can hold and fail) that were seen; formulas
/// that were executed.
struct CoverageTotals {
  Share plans;
  Share outcomes;
  Share formulas;
};

struct CoveredFile {
  SourcePtr source;
  /// By their places, which are in the order of the text.
  std::map<CoveredPlace, CoveredPlan> plans;
  std::map<CoveredPlace, CoveredRule> rules;

  [[nodiscard]] CoverageTotals totals() const;
};

struct SourceCoverage {
  /// By name, each of them once.
  std::map<std::string, CoveredFile> files;

  void add(const SourceCoverage& other);
  [[nodiscard]] CoverageTotals totals() const;
};

/// The place of a probe's subject (a plan's trigger, a rule's head, a condition, a formula) and its
/// text on one line.
struct WrittenAs {
  /// Null: it is not written anywhere (goal patterns rewrite plans), or the file is not known.
  SourcePtr source;
  CoveredPlace where;
  std::string text;
};

/// By the numbers of the probes.
struct ProbeTexts {
  std::vector<WrittenAs> plans;
  std::vector<WrittenAs> rules;
  std::vector<WrittenAs> conditions;
  std::vector<WrittenAs> formulas;
};

/// Looks the probes' subjects up in the programs' files; `sources` are the texts that are known.
[[nodiscard]] ProbeTexts find_texts(const Probes& probes, std::span<const SourcePtr> sources);

/// The coverage of the files whose texts are known.
[[nodiscard]] SourceCoverage locate(const Probes& probes, const CoverageCounts& counts,
                                    const ProbeTexts& texts);

/// A listing of code coverage: a table of the files, then each file with counts before its lines
/// and the uncovered parts below them. 80 columns, or more where the text is wider.
[[nodiscard]] std::string coverage_text(const SourceCoverage& coverage);
/// The coverage as a self-contained page; `subject`, a sentence's worth of text, names
/// what ran: the program, or the store, the behaviours and the tests.
[[nodiscard]] std::string coverage_html(const SourceCoverage& coverage, const std::string& subject);
/// As a tracefile of LCOV (geninfo(1)): plans are functions, outcomes of conditions are branches,
/// formulas are lines.
[[nodiscard]] std::string coverage_lcov(const SourceCoverage& coverage);

/// As `locate`, of programs whose files are read again.
[[nodiscard]] SourceCoverage locate_in_files(const Probes& probes, const CoverageCounts& counts,
                                             const SourceFiles& files);

/// Coverage by lines, which listings and tracefiles are made of.
struct CoveredLine {
  /// The greatest count of what begins on the line: how often a plan was chosen, a condition asked,
  /// a formula executed.
  std::uint64_t count = 0;
  /// Descriptions of the parts of the line that were not covered, in the order of the text.
  std::vector<std::string> gaps;
};

/// The lines on which something begins that can be covered.
[[nodiscard]] std::map<std::uint32_t, CoveredLine> covered_lines(const CoveredFile& file);

/// "75.0 %"; "-" of nothing.
[[nodiscard]] std::string percent(const Share& share);

}  // namespace jaywalk
