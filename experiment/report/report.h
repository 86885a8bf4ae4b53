// SPDX-License-Identifier: Apache-2.0
#pragma once

// The report: one self-contained HTML page, a section for each row of sections.def. A
// section is a function of ReportData in a file of sections/ that returns HTML (html.h and plot.h
// make it), or nothing if there is nothing to say. Read comparison.h and facts.h first.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/comparison.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/report/facts.h"
#include "experiment/results/reader.h"

namespace jaywalk::reporting {

/// A test that is named in the report: why, and the picture of its tracks or its page, if any.
struct ReplayLink {
  TestKey test;
  /// "the first that met the precondition", …
  std::string reason;
  /// The ways of all actors, from the store; empty if it has no scenes of the test.
  Recording recording;
  /// Relative to the report; empty if no page was written.
  std::string page;
};

/// A test that violates an assertion.
struct Violation {
  std::string assertion;
  TestKey test;
  double robustness = 0;
  std::optional<std::uint32_t> tick;
  std::string witness;
};

struct ReportData {
  Comparison comparison;
  ExperimentDescription description;
  /// The facts of each of the comparison's summaries, in the same order.
  std::vector<CellFacts> facts;
  /// The world that the tests ran in.
  std::shared_ptr<const PreparedScenario> prepared;
  /// The comparison's assertions with their texts; of assertions that are not here only the ids are
  /// known.
  std::vector<Assertion> assertions;
  /// Each behaviour's worst of each assertion; empty without a store.
  std::vector<Violation> violations;
  std::vector<ReplayLink> replays;
  /// The file it was made from; empty if there is none.
  std::string store_path;
  /// The store itself, for other data (single tests, recordings); null if there is none.
  const ResultsReader* store = nullptr;
};

/// The behaviours that the comparison has rows of, in their order: their numbers give the styles.
[[nodiscard]] std::vector<std::string> behaviours_of(const Comparison& comparison);
/// The numbers of agents, ascending.
[[nodiscard]] std::vector<std::uint32_t> agents_of(const Comparison& comparison);
/// The row; null if it is not there.
[[nodiscard]] const Summary* find_summary(const Comparison& comparison, std::string_view behaviour,
                                          std::uint32_t agents);

/// The test's entry in `data.replays`; null if it has none.
[[nodiscard]] const ReplayLink* find_replay(const ReportData& data, const TestKey& test);

struct Section {
  /// The name of the section's anchor in the page.
  std::string_view name;
  std::string_view title;
  std::string (*render)(const ReportData& data);
};

[[nodiscard]] std::span<const Section> sections();

[[nodiscard]] std::string render_report(const ReportData& data);

/// Reads a report's data from a store (verdicts, metrics, scenes) without running tests again. The
/// store must outlive the data.
[[nodiscard]] Result<ReportData> read_report_data(const ResultsReader& store);

namespace section {
#define JAYWALK_SECTION(name, title) std::string name(const ReportData& data);
#include "experiment/report/sections.def"
#undef JAYWALK_SECTION
}  // namespace section

}  // namespace jaywalk::reporting
