// SPDX-License-Identifier: Apache-2.0
// Our own. Its aim is not failing tests but failures that differ. A model learns from every test
// how severe the place was that came out worst, from the curvatures before it (severity_model.h);
// of many candidates, varied from what failed or nearly did, the next test is the one whose
// expected place is most probably a failure that is none of the known ones: expected improvement
// (Jones, Schonlau and Welch 1998, "Efficient global optimization of expensive black-box
// functions") of the number of distinct failures, with the novelty of Lehman and Stanley 2011
// ("Abandoning objectives"). What is near the road's beginning and end counts as different, too;
// with `unlike` also what makes the known failures sparser by the tool competition's measure
// (sites.h): a single failure that is unlike all others does that for each of them.
//
// Roads are as short as they can be: a test that fails soon costs little virtual time.

#include <algorithm>
#include <array>
#include <cmath>

#include "search/generator.h"
#include "search/generators/sites.h"
#include "search/test_input.h"

namespace jaywalk::search::generator::prospect {
namespace {

enum Parameter : std::size_t {
  kInitial,
  kExploration,
  kCandidates,
  kRounds,
  kReach,
  kMostValue,
  kVariation,
  kMostLead,
  kMostBack,
  kBrief,
  kMirrored,
  kContext,
  kUnlike,
};

constexpr std::array kParameters = {
    NumberParameter{"initial", 20, 1, 1e6, "random tests at the beginning"},
    NumberParameter{"exploration", 0.07, 0, 1, "share of random tests later"},
    NumberParameter{"candidates", 100, 1, 1e6, "that are looked at for each test"},
    NumberParameter{"rounds", 4, 0, 100, "in which the best of them are varied again"},
    NumberParameter{"reach_m", 2, 0.001, 1000, "from which on failures count as different"},
    NumberParameter{"most_value", 1.2, 0.01, 100, "of a sequence, to either side"},
    NumberParameter{"variation", 0.7, 0, 10, "of the values before a failure, at most"},
    NumberParameter{"most_lead", 6, 0, 100, "values before those, at most"},
    NumberParameter{"most_back", 7, 1, 100, "values before a failure that are varied, at most"},
    NumberParameter{"brief", 0.25, 0, 1, "share of candidates that begin and end at the failure"},
    NumberParameter{"mirrored", 0.1, 0, 1, "share of candidates that are mirrored"},
    NumberParameter{"context", 2, 0, 100, "weight of how near the road's ends are"},
    NumberParameter{"unlike", 0, 0, 100, "weight of how much sparser failures become"},
};

/// By how much a failure may be nearer or farther than expected and must be new all the same.
constexpr std::array kShifts_m = {0.0, -2.0, 2.0};
/// How a certain failure is preferred to a new one.
constexpr double kCertainty = 0.8;
constexpr std::size_t kElite = 4;
constexpr double kRefinement = 0.2;
/// Tests that came this near to failing are varied, too.
constexpr double kNearMiss = 0.75;
/// The severity of tests that failed; just below fails_at it is nearly 1.
constexpr double kFailed = 1.05;
constexpr int kAttempts = 3;
constexpr double kElsewhere = 0.5;
/// The unit of gains in sparseness, and the most units that count: the model is least sure of the
/// roads that promise most.
constexpr double kUnlike_m = 10;
constexpr double kMostUnlike = 3;
/// A third of the random roads is hardly longer than it must be.
constexpr double kShortRoads = 0.3;

using Values = std::vector<double>;

struct Candidate {
  Site site;
  double score = 0;
  bool valid = false;
};

/// An executed test: the place where it failed or came nearest to failing.
struct Find {
  Site site;
  double severity = 0;
};

class Prospect : public Generator {
 public:
  explicit Prospect(const GeneratorSetup& setup)
      : space_(setup.space),
        sequences_(setup.space.sequences()),
        where_(find_measure(setup.measures, "worst_arc_m")),
        fails_at_(setup.fitness.fails_at),
        values_(setup.values),
        most_(sequences_ ? values_[kMostValue] : 1),
        random_(setup.seed),
        view_(setup.space),
        model_(view_.lengths()),
        known_(values_[kReach]) {}

  TestInput ask(Asking& asking) override {
    expected_.reset();
    ++asked_;
    const bool explores = finds_.empty() || static_cast<double>(asked_) <= values_[kInitial] ||
                          random_.uniform(0, 1) < values_[kExploration];
    for (int i = 0; i < kAttempts && !explores && !expected_; ++i) expected_ = best_site(asking);
    if (expected_) return expected_->input;
    return draw_valid(asking, [&] { return random_input(); });
  }

  void tell(const ExecutedTest& test, double) override {
    const Form natural = sequences_ ? Form::sequence : Form::vector;
    if (!test.outcome.executed() || test.input.form != natural) return;
    const Find find{{test.input, worst_place(test)}, severity(test)};
    model_.add(view_.features(find.site), find.severity);
    // The place expected to fail passed, even if another place was the worst.
    if (expected_ && !test.failed && std::abs(expected_->at() - find.site.at()) > 1) {
      model_.add(view_.features(*expected_), find.severity);
    }
    if (find.severity > kNearMiss) finds_.push_back(find);
    if (!test.failed) return;
    const TestInput points = space_.as_points(test.input);
    known_.add(view_.shape(find.site, points), view_.surroundings_m(find.site));
    if (sequences_ && values_[kUnlike] > 0)
      turns_.add(turns_near(find.site, points, sequences_->element_m));
  }

 private:
  [[nodiscard]] double worst_place(const ExecutedTest& test) const {
    if (!sequences_) return 0;
    const auto last = static_cast<double>(test.input.values.size()) - 1;
    // The measured place of the failure; without that measure, a place before the end.
    const double place = where_ ? test.outcome.measures[*where_] / sequences_->element_m : last - 2;
    return std::clamp(place, 0.0, last);
  }

  [[nodiscard]] double severity(const ExecutedTest& test) const {
    return test.failed ? kFailed : test.fitness / fails_at_;
  }

  /// The site that promises most; none if no candidate is valid.
  std::optional<Site> best_site(Asking& asking) {
    const auto rounds = static_cast<int>(values_[kRounds]);
    const auto each = static_cast<int>(values_[kCandidates]) / (rounds + 1) + 1;
    std::vector<Candidate> best;
    for (int round = 0; round <= rounds; ++round) {
      if (round > 0 && best.empty()) return std::nullopt;
      std::vector<Candidate> fresh;
      for (int i = 0; i < each; ++i) {
        fresh.push_back({round == 0 ? varied() : refined(best[random_.below(best.size())].site)});
      }
      rate(fresh);
      best.insert(best.end(), std::make_move_iterator(fresh.begin()),
                  std::make_move_iterator(fresh.end()));
      keep_best(best, asking);
    }
    if (best.empty()) return std::nullopt;
    return best.front().site;
  }

  /// How probably each fails, and how new that would be. Those that do not fit the map are left
  /// out.
  void rate(std::vector<Candidate>& candidates) {
    std::vector<TestInput> points;
    std::erase_if(candidates, [&](const Candidate& each) {
      TestInput made = space_.as_points(each.site.input);
      if (made.values.empty()) return true;
      points.push_back(std::move(made));
      return false;
    });
    learn::SeverityModel::Places places(model_.features(), candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Values features = view_.features(candidates[i].site);
      std::ranges::copy(features, places.col(static_cast<Eigen::Index>(i)).begin());
    }
    const Eigen::ArrayXd failing = model_.failure_probability(places);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double probability = failing(static_cast<Eigen::Index>(i));
      candidates[i].score =
          std::pow(probability, kCertainty) * novelty(candidates[i].site, points[i]);
    }
  }

  [[nodiscard]] double novelty(const Site& site, const TestInput& points) const {
    double least = 1;
    for (const double shift : kShifts_m) {
      least = std::min(least, known_.novelty(view_.shape(site, points, shift)));
      if (!sequences_) break;
    }
    if (!sequences_) return least;
    const double elsewhere = known_.surroundings_novelty_m(view_.surroundings_m(site)) /
                             KnownFailures::kMostDifference_m;
    const double value = least * (1 + values_[kContext] * elsewhere);
    if (values_[kUnlike] <= 0) return value;
    const double unlike = turns_.gain(turns_near(site, points, sequences_->element_m));
    return value + values_[kUnlike] * std::clamp(unlike / kUnlike_m, 0.0, kMostUnlike);
  }

  /// The best valid ones, the best first.
  static void keep_best(std::vector<Candidate>& candidates, Asking& asking) {
    std::ranges::stable_sort(candidates, std::greater<>{}, &Candidate::score);
    std::vector<Candidate> kept;
    for (Candidate& each : candidates) {
      if (!each.valid && !asking.valid(each.site.input)) continue;
      each.valid = true;
      kept.push_back(std::move(each));
      if (kept.size() == kElite) break;
    }
    candidates = std::move(kept);
  }

  [[nodiscard]] double clamped(double value) const { return std::clamp(value, -most_, most_); }

  /// The more severe of two finds.
  const Find& pick() {
    const Find& one = finds_[random_.below(finds_.size())];
    const Find& other = finds_[random_.below(finds_.size())];
    return other.severity > one.severity ? other : one;
  }

  Site varied() {
    // A vector says nothing of where in it the failure is: look everywhere, too.
    if (!sequences_ && random_.uniform(0, 1) < kElsewhere) return {random_input(), 0};
    Site site = sequences_ ? varied_sequence(pick().site) : varied_vector(pick().site);
    if (random_.uniform(0, 1) < values_[kMirrored]) {
      for (double& value : site.input.values) value = -value;
    }
    return site;
  }

  Site varied_vector(const Site& parent) {
    Site site = parent;
    const double most = values_[kVariation] * std::pow(random_.uniform(0, 1), 2);
    for (double& value : site.input.values) {
      if (random_.coin()) value = clamped(value + random_.uniform(-most, most));
    }
    return site;
  }

  /// The values around a failure, varied; after them new ones, before them new or the former ones.
  Site varied_sequence(const Site& parent) {
    const double most = values_[kVariation] * std::pow(random_.uniform(0, 1), 2);
    const int back =
        std::min(random_.between(1, static_cast<int>(values_[kMostBack])), parent.at());
    Values core = varied_core(parent, back, most);
    Site site{{Form::sequence, lead(parent, parent.at() - back, core.front(), most)}, 0};
    Values& values = site.input.values;
    site.place = static_cast<double>(values.size()) + back + (parent.place - parent.at());
    values.insert(values.end(), core.begin(), core.end());
    if (random_.uniform(0, 1) < values_[kBrief]) {
      shorten(site);
    } else {
      append_random(values, random_.between(2, 5), random_);
    }
    return site;
  }

  /// From `back` values before the place to one after it: all of them varied, or a few much.
  Values varied_core(const Site& parent, int back, double most) {
    constexpr double kFew = 0.3;
    constexpr double kHardly = 0.03;
    const Values& values = parent.input.values;
    const auto begin = static_cast<std::size_t>(parent.at() - back);
    const std::size_t end = std::min(values.size(), static_cast<std::size_t>(parent.at()) + 2);
    const bool all = random_.coin();
    Values core;
    for (std::size_t i = begin; i < end; ++i) {
      const double by = all ? most : random_.uniform(0, 1) < kFew ? 2 * most : kHardly;
      core.push_back(clamped(values[i] + random_.uniform(-by, by)));
    }
    return core;
  }

  /// The values before `next`: the parent's last of `have` values, varied, or new ones.
  Values lead(const Site& parent, int have, double next, double most) {
    int count = random_.between(0, static_cast<int>(values_[kMostLead]));
    Values values;
    if (random_.coin()) {
      for (int i = have - std::min(have, count); i < have; ++i) {
        const double value = parent.input.values[static_cast<std::size_t>(i)];
        values.push_back(clamped(value + random_.uniform(-most, most)));
      }
      return values;
    }
    Values backwards{next};
    append_random(backwards, count, random_);
    return {backwards.rbegin(), backwards.rend() - 1};
  }

  /// Begins at most three values before the place and ends soon after it.
  void shorten(Site& site) {
    Values& values = site.input.values;
    const int cut = std::max(0, site.at() - random_.between(1, 3));
    values.erase(values.begin(), values.begin() + cut);
    site.place -= cut;
    values.push_back(random_.uniform(-1, 1));
    values.push_back(0);
  }

  /// A candidate with all values or a single one changed a little.
  Site refined(Site site) {
    Values& values = site.input.values;
    const double most = kRefinement * random_.uniform(0, 1);
    if (random_.coin()) {
      double& value = values[random_.below(values.size())];
      value = clamped(value + 2 * random_.uniform(-most, most));
      return site;
    }
    for (double& value : values) value = clamped(value + random_.uniform(-most, most));
    return site;
  }

  /// Roads of any length and any vigour.
  TestInput random_input() {
    if (!sequences_) {
      TestInput input{Form::vector, Values(space_.dimension())};
      for (double& value : input.values) value = random_.uniform(-1, 1);
      return input;
    }
    const bool is_short = random_.uniform(0, 1) < kShortRoads;
    const double most = random_.uniform(std::min(0.8, most_), most_);
    const double difference = random_.uniform(0.4, is_short ? 1.8 : 1.2);
    const int length = is_short ? random_.between(5, 8) : random_.between(8, 22);
    TestInput input{Form::sequence, {}};
    double last = 0;
    for (int i = 0; i < length; ++i) {
      last = random_.uniform(std::max(-most, last - difference), std::min(most, last + difference));
      input.values.push_back(last);
    }
    return input;
  }

  const SearchSpace& space_;
  std::optional<SequenceBounds> sequences_;
  std::optional<std::size_t> where_;
  double fails_at_;
  std::span<const double> values_;
  double most_;
  Random random_;
  SiteView view_;
  learn::SeverityModel model_;
  KnownFailures known_;
  KnownTurns turns_;
  std::vector<Find> finds_;
  std::optional<Site> expected_;
  std::size_t asked_ = 0;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<Prospect>(setup);
}

}  // namespace jaywalk::search::generator::prospect
