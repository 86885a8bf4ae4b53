// SPDX-License-Identifier: Apache-2.0
#pragma once

// The figures of the paper that the case study repeats, to be shown beside ours. They are data
// (paper_figures.csv, which names their source), built into the program. They belong to one world,
// one set of parameters and the programs of agents/crossing: published_rows() says of which
// behaviours they may be shown.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/measures/measures.h"

namespace jaywalk {

class PreparedScenario;

/// Whether a run repeats the quirks of the program that the published figures come from.
enum class PublishedQuirks { left_out, repeated };

/// Which rows of a comparison the published figures may stand beside.
struct PublishedRows {
  /// The world is one that was published, so that the paper's own measures are shown.
  bool world = false;
  /// Behaviours whose world, program and parameters are those that were published.
  std::vector<std::string> behaviours;
  /// Why figures of other behaviours are left out, in one line; empty if the paper has none of
  /// these.
  std::string left_out;
  PublishedQuirks quirks = PublishedQuirks::left_out;
};

/// Compares the scenario with the presets whose results were published (Preset::results): the whole
/// world, the behaviours' parameters, and the texts of their programs with those of
/// agents/crossing.
[[nodiscard]] PublishedRows published_rows(const PreparedScenario& prepared);

/// The paper's figure for a measure; nothing if it has none, or none that may be shown.
[[nodiscard]] std::optional<Estimate> published_figure(const PublishedRows& rows,
                                                       const Measure& measure,
                                                       std::string_view behaviour,
                                                       std::uint32_t agents);

/// Whether tables and pictures have the measure: some make sense in the paper's world alone.
[[nodiscard]] bool is_shown(const PublishedRows& rows, const Measure& measure);

/// Whether the paper has figures for behaviours of that name.
[[nodiscard]] bool has_published_figures(std::string_view behaviour);

/// Notes for readers of published figures, as lines without line breaks: where the figures come
/// from and why ours differ, or why they are left out. Empty if the paper has no such figures.
[[nodiscard]] std::vector<std::string> published_notes(const PublishedRows& rows);

}  // namespace jaywalk
