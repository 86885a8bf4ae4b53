// SPDX-License-Identifier: Apache-2.0
#pragma once

// The results of searches as a self-contained HTML page: the paper's Table 1 and Figures 1 to 3
// with ours, fitness over time, the last tests of each generator, clusters of failing tests. Read
// search_tables.h first.

#include <string>
#include <string_view>

#include "search/report/search_tables.h"
#include "search/search.h"
#include "search/search_experiment.h"
#include "search/suts/road_space.h"

namespace jaywalk::search {

/// The whole page; what follows are parts of it.
[[nodiscard]] std::string to_html(const SearchExperiment& experiment,
                                  const std::vector<GeneratorResults>& generators);

/// The clusters of failures in all repetitions; `number` is the generator's, which gives the
/// colour. Tests on roads are the same if the stretches on which they failed are within a metre of
/// each other (failing_stretch.h), others if their signatures are nearer than half the median
/// distance.
[[nodiscard]] std::string clusters_html(const GeneratorResults& generator, const SutModel& model,
                                        std::size_t number);

/// Whether a search was set up as the published ones were: the published roads, a test fails from
/// 95 % of the car out of its lane on, no speed limit, two hours. Which car drives does not matter:
/// the published one was BeamNG.tech's. An external car's speed limit is not known; it never is.
[[nodiscard]] bool is_as_published(const SearchExperiment& experiment);

/// Table 1 of Peltomäki, Spencer and Porres 2022 as HTML, or a line that says why it is left out;
/// empty if no roads are searched.
[[nodiscard]] std::string published_table(const SearchExperiment& experiment);

/// System under test, generators, budget, fitness.
[[nodiscard]] std::string setup_html(const SearchExperiment& experiment);

/// The command and the experiment's text.
[[nodiscard]] std::string reproduce_html(const SearchExperiment& experiment);

/// Roads as small pictures side by side, in their generator's colour, with a scale bar in metres.
class RoadPictures {
 public:
  /// `generator`: its number, which gives the colour. The model must outlive the pictures.
  /// REQUIRES: a SUT that drives on roads.
  RoadPictures(const SutModel& model, std::size_t generator)
      : model_(model), space_(*model.road_space()), generator_(generator) {}

  /// The road, its beginning as a bar across, and a dot beside the place where the car was farthest
  /// out of its lane, if that is known.
  void add(const TestRow& row, std::string_view caption);
  /// There are as many as are looked at.
  [[nodiscard]] bool full() const { return count_ >= kShown; }
  [[nodiscard]] std::string html() const;

  static constexpr std::size_t kShown = 8;

 private:
  const SutModel& model_;
  const RoadSpace& space_;
  std::size_t generator_;
  std::size_t count_ = 0;
  std::string figures_;
};

}  // namespace jaywalk::search
