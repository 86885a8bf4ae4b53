// SPDX-License-Identifier: Apache-2.0
// MAP-Elites (Mouret and Clune 2015, "Illuminating search spaces by mapping elites", arXiv
// 1504.04909): a map of what tests are like, and in each of its cells the worst test of that kind.
// Elites of random cells are varied. The map's axes are those of the SBST tool competition's
// coverage: a road's largest curvature and the directions that it heads for; of vectors, their
// first two numbers. Where the system under test measures situations, their bins are the cells, and
// of two cells that chance picks the one that fewer tests have met comes first.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "search/evolve/evolution.h"
#include "search/generator.h"
#include "search/sut.h"

namespace jaywalk::search::generator::map_elites {
namespace {

enum Parameter : std::size_t { kInitial, kCells, kVariation, kCurvatures };

constexpr std::array kParameters = {
    NumberParameter{"initial", 60, 1, 1e6, "random tests at the beginning"},
    NumberParameter{"cells", 25, 1, 1000, "of the map along each axis"},
    NumberParameter{"variation", 0.3, 0, 10, "by which numbers are varied at most"},
    NumberParameter{"curvatures", 17, 3, 1000, "of each road"},
};

/// 36 directions of ten degrees, as the competition counts.
constexpr int kDirections = 36;
/// The unit for a road's largest curvature: that of the least valid radius, in 1/m.
constexpr double kMostCurvature = 0.07;

using Cell = std::pair<int, int>;

struct Elite {
  Genes genes;
  double fitness = 0;
};
/// A bin of a situation.
struct Met {
  Elite elite;
  std::uint64_t times = 0;
};

/// How sharp the road of these points turns at most, and into how many directions it heads, both
/// from 0 to 1.
std::pair<double, double> describe_road(std::span<const double> xy) {
  double sharpest = 0;
  double last_heading = 0;
  std::set<int> directions;
  for (std::size_t i = 0; i + 3 < xy.size(); i += 2) {
    const double dx = xy[i + 2] - xy[i];
    const double dy = xy[i + 3] - xy[i + 1];
    const double heading = std::atan2(dy, dx);
    const double turns = heading / (2 * std::numbers::pi) + 0.5;
    directions.insert(std::min(kDirections - 1, static_cast<int>(turns * kDirections)));
    const double turn = std::remainder(heading - last_heading, 2 * std::numbers::pi);
    if (i > 0) sharpest = std::max(sharpest, std::fabs(turn) / std::hypot(dx, dy));
    last_heading = heading;
  }
  return {sharpest / kMostCurvature, static_cast<double>(directions.size()) / kDirections};
}

class MapElites : public Generator {
 public:
  explicit MapElites(const GeneratorSetup& setup)
      : space_(setup.space),
        measures_(setup.measures),
        values_(setup.values),
        random_(setup.seed),
        genome_(setup.space, static_cast<std::size_t>(values_[kCurvatures])) {}

  TestInput ask(Asking& asking) override {
    const bool empty = elites_.empty() && met_.empty();
    const bool draws = static_cast<double>(asked_++) < values_[kInitial] || empty;
    return draw_valid(asking, [&] {
      asked_for_ = draws ? genome_.draw(random_) : varied();
      return genome_.express(asked_for_);
    });
  }

  void tell(const ExecutedTest& test, double) override {
    if (const auto bins = situation_bins(test.outcome, measures_)) return tell(test, *bins);
    Elite& elite = elites_.try_emplace(cell(test.input), Elite{{}, -1}).first->second;
    if (test.fitness > elite.fitness) elite = {asked_for_, test.fitness};
  }

 private:
  [[nodiscard]] Cell cell(const TestInput& input) const {
    std::pair<double, double> place{0, 0};
    if (genome_.is_road()) {
      place = describe_road(space_.as_points(input).values);
    } else {
      place.first = (input.values.front() + 1) / 2;
      place.second = (input.values[input.values.size() > 1 ? 1 : 0] + 1) / 2;
    }
    const auto index = [&](double share) {
      return static_cast<int>(std::clamp(share, 0.0, 0.9999) * values_[kCells]);
    };
    return {index(place.first), index(place.second)};
  }

  void tell(const ExecutedTest& test, const SituationBins& bins) {
    for (std::size_t item = 0; item < bins.size(); ++item) {
      if (!bins[item]) continue;
      Met& met = met_[{static_cast<int>(item), static_cast<int>(*bins[item])}];
      ++met.times;
      if (test.fitness >= met.elite.fitness) met.elite = {asked_for_, test.fitness};
    }
  }

  const Genes& parent() {
    if (met_.empty()) {
      const auto steps = static_cast<std::ptrdiff_t>(random_.below(elites_.size()));
      return std::next(elites_.begin(), steps)->second.genes;
    }
    const auto any = [this] {
      const auto steps = static_cast<std::ptrdiff_t>(random_.below(met_.size()));
      return std::next(met_.begin(), steps);
    };
    const auto one = any();
    const auto other = any();
    return (other->second.times < one->second.times ? other : one)->second.elite.genes;
  }

  /// Half of the numbers of the elite of some cell, varied.
  Genes varied() {
    Genes genes = parent();
    for (double& gene : genes) {
      if (random_.coin()) gene += random_.uniform(-values_[kVariation], values_[kVariation]);
    }
    return genes;
  }

  const SearchSpace& space_;
  std::span<const MeasureKind> measures_;
  std::span<const double> values_;
  Random random_;
  Genome genome_;
  std::map<Cell, Elite> elites_;
  std::map<Cell, Met> met_;
  Genes asked_for_;
  std::size_t asked_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<MapElites>(setup);
}

}  // namespace jaywalk::search::generator::map_elites
