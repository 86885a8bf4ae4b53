// SPDX-License-Identifier: Apache-2.0
// AmbieGen (Humeniuk, Khomh and Antoniol 2022, "A search-based framework for automatic generation
// of testing environments for cyber-physical systems", and at the SBST 2022 tool competition):
// NSGA-II evolves roads of straight pieces and turns towards roads that a simplified car leaves
// farthest and that differ from the five best. No test is executed for that; then those of the
// first front are, and it begins anew.
//
// Where there are no roads, difference alone is left: of many random vectors the one that is
// farthest from the last five.

#include <algorithm>
#include <array>
#include <deque>
#include <limits>

#include "search/evolve/nsga2.h"
#include "search/evolve/road_elements.h"
#include "search/generator.h"
#include "search/run_summary.h"

namespace jaywalk::search::generator::ambiegen {
namespace {

enum Parameter : std::size_t {
  kPopulation,
  kChildren,
  kGenerations,
  kCrossover,
  kMutation,
  kLeastDeviation,
  kMap,
};

constexpr std::array kParameters = {
    NumberParameter{"population", 150, 2, 1e6, "roads that live at once"},
    NumberParameter{"children", 50, 1, 1e6, "of each generation"},
    NumberParameter{"generations", 200, 0, 1e6, "until the first front is executed"},
    NumberParameter{"crossover", 0.9, 0, 1, "share of pairs that are crossed"},
    NumberParameter{"mutation", 0.4, 0, 1, "share of children that are mutated"},
    NumberParameter{"least_deviation_m", 4, 0, 1000, "of the simplified car that is required"},
    NumberParameter{"map_m", 200, 50, 10'000, "width of the map that roads are drawn on"},
};

constexpr std::size_t kBest = 5;
constexpr int kMostRoads = 10'000;
constexpr int kMostPairs = 1000;  // for the children of a generation

struct Road {
  RoadElements elements;
  TestInput input;
  Worth worth;
};

class AmbieGen : public Generator {
 public:
  explicit AmbieGen(const GeneratorSetup& setup)
      : space_(setup.space),
        is_road_(setup.space.sequences().has_value()),
        values_(setup.values),
        random_(setup.seed) {}

  TestInput ask(Asking& asking) override {
    if (!is_road_) return farthest(asking);
    if (queue_.empty()) evolve(asking);
    if (queue_.empty()) return draw_valid(asking, [&] { return space_.draw_initial(random_); });
    TestInput input = std::move(queue_.front());
    queue_.pop_front();
    return input;
  }

  void tell(const ExecutedTest& test, double) override {
    if (is_road_) return;
    last_.push_back(test.input.values);
    if (last_.size() > kBest) last_.pop_front();
  }

 private:
  /// Evolves a population and queues its first front.
  void evolve(Asking& asking) {
    std::vector<Road> roads;
    const auto size = static_cast<std::size_t>(values_[kPopulation]);
    for (int i = 0; i < kMostRoads && roads.size() < size; ++i) {
      Road road = judged(drawn(), {}, asking);
      if (!road.input.values.empty()) roads.push_back(std::move(road));
    }
    std::vector<Standing> standings = select(roads);
    const auto generations = static_cast<int>(values_[kGenerations]);
    for (int i = 0; i < generations && !roads.empty(); ++i) {
      breed(roads, standings, asking);
      standings = select(roads);
    }
    for (std::size_t i = 0; i < roads.size(); ++i) {
      if (standings[i].front == 0) queue_.push_back(std::move(roads[i].input));
    }
  }

  /// Keeps the best, the best first; returns how they stand.
  std::vector<Standing> select(std::vector<Road>& roads) const {
    std::vector<Worth> worths;
    for (const Road& each : roads) worths.push_back(each.worth);
    const std::vector<Standing> all = rank(worths);
    std::vector<Road> kept;
    std::vector<Standing> standings;
    for (const std::size_t i : survivors(all, static_cast<std::size_t>(values_[kPopulation]))) {
      kept.push_back(std::move(roads[i]));
      standings.push_back(all[i]);
    }
    roads = std::move(kept);
    return standings;
  }

  void breed(std::vector<Road>& roads, std::span<const Standing> standings, Asking& asking) {
    const std::vector<Road> best(
        roads.begin(), roads.begin() + static_cast<std::ptrdiff_t>(std::min(kBest, roads.size())));
    const auto count = roads.size() + static_cast<std::size_t>(values_[kChildren]);
    const auto is_new = [&](const Road& child) {
      return std::ranges::none_of(
          roads, [&](const Road& each) { return each.elements == child.elements; });
    };
    // Copies would fill the first front; where nothing else comes any more, there are fewer.
    for (int pair = 0; pair < kMostPairs && roads.size() < count; ++pair) {
      RoadElements a = roads[tournament(standings, random_)].elements;
      RoadElements b = roads[tournament(standings, random_)].elements;
      if (random_.uniform(0, 1) < values_[kCrossover]) cross(a, b);
      for (RoadElements* child : {&a, &b}) {
        if (random_.uniform(0, 1) < values_[kMutation]) mutate(*child);
        Road made = judged(std::move(*child), best, asking);
        if (roads.size() < count && is_new(made)) roads.push_back(std::move(made));
      }
    }
  }

  /// The road with the simplified car's result and its difference from the best. Without an input,
  /// and of no value, if it is not a valid road.
  Road judged(RoadElements elements, std::span<const Road> best, Asking& asking) {
    Road road{std::move(elements), {Form::points, {}}, {{}, values_[kLeastDeviation]}};
    const lane::Polyline points = element_points(road.elements, values_[kMap]);
    road.elements.resize(std::min(road.elements.size(), points.size() - 1));
    TestInput input{Form::points, {}};
    for (const Point& point : points) {
      input.values.push_back(point.x_m);
      input.values.push_back(point.y_m);
    }
    if (points.size() < 3 || !asking.valid(input)) return road;
    road.input = std::move(input);
    const double deviation = simplified_deviation_m(points);
    double novelty = 0;
    for (const Road& each : best) {
      novelty += difference(each.elements, road.elements) / static_cast<double>(best.size());
    }
    road.worth = {{deviation, novelty}, std::max(0.0, values_[kLeastDeviation] - deviation)};
    return road;
  }

  /// Elements until the map is left.
  RoadElements drawn() {
    RoadElements elements;
    do {
      elements.push_back(draw_element(random_));
    } while (element_points(elements, values_[kMap]).size() > elements.size());
    elements.pop_back();
    return elements;
  }

  /// At one place of the shorter one.
  void cross(RoadElements& a, RoadElements& b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    if (shorter < 2) return;
    const auto at = static_cast<std::ptrdiff_t>(1 + random_.below(shorter - 1));
    RoadElements child(a.begin(), a.begin() + at);
    child.insert(child.end(), b.begin() + at, b.end());
    b.erase(b.begin() + at, b.end());
    b.insert(b.end(), a.begin() + at, a.end());
    a = std::move(child);
  }

  /// Two elements exchanged, or one that becomes another.
  void mutate(RoadElements& elements) {
    if (elements.empty()) return;
    RoadElement& one = elements[random_.below(elements.size())];
    if (random_.coin()) {
      std::swap(one, elements[random_.below(elements.size())]);
    } else {
      one = draw_other(one, random_);
    }
  }

  TestInput farthest(Asking& asking) {
    TestInput best;
    double most = -1;
    const auto draw = [&] {
      TestInput input{Form::vector, std::vector<double>(space_.dimension())};
      for (double& value : input.values) value = random_.uniform(-1, 1);
      return input;
    };
    for (int i = 0; i < static_cast<int>(values_[kPopulation]); ++i) {
      TestInput input = draw();
      if (!asking.valid(input)) continue;
      double least = std::numeric_limits<double>::max();
      for (const auto& each : last_)
        least = std::min(least, euclidean_distance(each, input.values));
      if (least <= most) continue;
      most = least;
      best = std::move(input);
    }
    return best.values.empty() ? draw_valid(asking, draw) : best;
  }

  const SearchSpace& space_;
  bool is_road_;
  std::span<const double> values_;
  Random random_;
  std::deque<TestInput> queue_;
  std::deque<std::vector<double>> last_;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<AmbieGen>(setup);
}

}  // namespace jaywalk::search::generator::ambiegen
