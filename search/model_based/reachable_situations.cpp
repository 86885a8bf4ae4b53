// SPDX-License-Identifier: Apache-2.0
#include "search/model_based/reachable_situations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <thread>
#include <unordered_set>

#include <fmt/format.h>

#include "experiment/test_run/test_run.h"

namespace jaywalk::search {
namespace {

/// Walks that are followed between two looks at limits: a tenth of a second.
constexpr std::size_t kAtOnce = 64;

/// The situation after a walk.
struct Step {
  ScriptedWalk walk;
  /// The key of the state, by which equal ones are recognised, if the walk goes on; the covered
  /// bins, if it has met the precondition.
  std::string state = {};
  SituationBins bins = {};
  enum class End { goes_on, met, over } end = End::goes_on;
};

/// Runs walks, on one thread.
class Walker {
 public:
  explicit Walker(const ReachPlan& plan)
      : plan_(plan),
        ground_(plan.prepared->scenario().world->ground()),
        brakes_(plan.prepared->scenario().world->vehicle().model != "constant"),
        runner_(*plan.prepared) {}

  Step follow(ScriptedWalk walk) {
    Recording recording;
    const TestSetup setup{.behaviour = plan_.behaviour,
                          .agents = 1,
                          .seed = plan_.seed,
                          .starts = {walk.start},
                          .parameters = {{"moves", {walk.moves}, {}}}};
    // The scene of the last tick before a limit is not recorded, so that is one tick more, in which
    // it stays.
    const std::size_t ticks = walk.moves.size();
    const TestRun result = runner_.run(setup, {.record = &recording, .max_ticks = ticks + 1});
    const WorldResult& outcome = result.outcome;
    const auto within = [&](int tick) { return static_cast<std::size_t>(tick) <= ticks; };
    Step step{.walk = std::move(walk)};
    if (outcome.success && within(outcome.ticks)) {
      step.end = Step::End::met;
      step.bins = covered_bins(recording, ground_);
    } else if (recording.scenes() <= ticks || (!outcome.end.empty() && within(outcome.all_ticks))) {
      step.end = Step::End::over;
    }
    if (step.end == Step::End::goes_on) step.state = state_of(recording, ticks);
    return step;
  }

 private:
  [[nodiscard]] std::string state_of(const Recording& recording, std::size_t tick) const {
    const TestView view(recording, ground_);
    const Situation now{view, 1, tick};
    const auto bin = [](std::optional<std::uint32_t> which) { return which ? int(*which) : -1; };
    const double late = std::ceil(situation::kLate_s / view.tick_s());
    std::string state =
        fmt::format("{} {} {}", std::min(static_cast<double>(tick), late),
                    bin(situation::start_side(now)), bin(situation::start_band(now)));
    for (const ActorState& actor : recording.scene(tick)) {
      state += fmt::format(" {:.3f} {:.3f}", actor.x_m, actor.y_m);
      if (brakes_) state += fmt::format(" {:.3f} {:.3f}", actor.speed_mps, actor.heading_rad);
    }
    return state;
  }

  const ReachPlan& plan_;
  Ground ground_;
  bool brakes_;
  TestRunner runner_;
};

class Explorer {
 public:
  explicit Explorer(const ReachPlan& plan) : plan_(plan) {
    for (unsigned i = 0; i < std::max(1U, plan.threads); ++i) {
      walkers_.push_back(std::make_unique<Walker>(plan));
    }
    for (const SituationItem& item : situation_items()) {
      found_.walks.emplace_back(item.bins.size());
    }
  }

  Reach explore() {
    std::vector<ScriptedWalk> frontier = starts();
    found_.starts = frontier.size();
    std::uint32_t ticks = 0;
    while (!frontier.empty()) {
      if (ticks == plan_.most_ticks) return std::move(found_);
      std::optional<std::vector<ScriptedWalk>> longer = next(frontier);
      if (!longer) return std::move(found_);
      frontier = std::move(*longer);
      ++ticks;
    }
    found_.complete = true;
    return std::move(found_);
  }

 private:
  /// In which tests begin, each once.
  [[nodiscard]] std::vector<ScriptedWalk> starts() const {
    std::set<std::pair<int, int>> cells;
    for (std::uint64_t test = 0; test < plan_.tests; ++test) {
      for (const Position cell : start_cells(plan_.prepared->scenario(),
                                             {.agents = 1, .seed = plan_.seed, .test = test})) {
        cells.emplace(cell.x, cell.y);
      }
    }
    std::vector<ScriptedWalk> walks;
    for (const auto& [row, cell] : cells) walks.push_back({{row, cell}, {}});
    return walks;
  }

  /// The walks that are a move longer, of each new state one: the first, in the order of `walks`.
  /// Nothing if the limit of states is reached, or the search is interrupted.
  std::optional<std::vector<ScriptedWalk>> next(const std::vector<ScriptedWalk>& walks) {
    std::vector<ScriptedWalk> longer;
    for (std::size_t from = 0; from < walks.size(); from += kAtOnce) {
      if (plan_.interrupted && plan_.interrupted()) return std::nullopt;
      const auto some = std::span(walks).subspan(from, std::min(kAtOnce, walks.size() - from));
      for (Step& step : follow(some)) {
        if (step.end == Step::End::met) note(step);
        if (step.end != Step::End::goes_on || !states_.insert(std::move(step.state)).second)
          continue;
        longer.push_back(std::move(step.walk));
        if (++found_.states > plan_.most_states) return std::nullopt;
      }
    }
    return longer;
  }

  /// Each of the walks with each move behind it.
  std::vector<Step> follow(std::span<const ScriptedWalk> walks) {
    std::vector<Step> steps(walks.size() * kWalkLetters.size());
    const auto work = [&](std::size_t first) {
      for (std::size_t i = first; i < steps.size(); i += walkers_.size()) {
        ScriptedWalk walk = walks[i / kWalkLetters.size()];
        walk.moves += kWalkLetters[i % kWalkLetters.size()];
        steps[i] = walkers_[first]->follow(std::move(walk));
      }
    };
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < walkers_.size(); ++i) threads.emplace_back(work, i);
    work(0);
    threads.clear();
    return steps;
  }

  void note(const Step& step) {
    for (std::size_t item = 0; item < step.bins.size(); ++item) {
      if (!step.bins[item]) continue;
      std::optional<ScriptedWalk>& walk = found_.walks[item][*step.bins[item]];
      if (!walk) walk = step.walk;
    }
  }

  const ReachPlan& plan_;
  std::vector<std::unique_ptr<Walker>> walkers_;
  std::unordered_set<std::string> states_;
  Reach found_;
};

}  // namespace

Reach reach(const ReachPlan& plan) { return Explorer(plan).explore(); }

std::uint64_t reachable(const std::vector<std::optional<ScriptedWalk>>& item) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(item, [](const auto& walk) { return walk.has_value(); }));
}

std::string reach_text(const Reach& reach) {
  std::string text;
  std::uint64_t all = 0;
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < reach.walks.size(); ++i) {
    const SituationItem& item = situation_items()[i];
    all += item.bins.size();
    met += reachable(reach.walks[i]);
    text += fmt::format("{} ({}): {} of {}\n", item.name, item.summary, reachable(reach.walks[i]),
                        item.bins.size());
    for (std::size_t bin = 0; bin < item.bins.size(); ++bin) {
      if (!reach.walks[i][bin]) text += fmt::format("  never: {}\n", item.bins[bin]);
    }
  }
  return text + fmt::format("\n{} of {} bins can be met ({} start cells, {} states{})\n", met, all,
                            reach.starts, reach.states,
                            reach.complete ? "" : "; not all walks were followed to their end");
}

std::string reach_csv(const Reach& reach) {
  std::string text = fmt::format("{}\n", kReachHeader);
  for (std::size_t i = 0; i < reach.walks.size(); ++i) {
    const SituationItem& item = situation_items()[i];
    for (std::size_t bin = 0; bin < item.bins.size(); ++bin) {
      const std::optional<ScriptedWalk>& walk = reach.walks[i][bin];
      text += fmt::format("{},{},\"{}\",", item.name, bin + 1, item.bins[bin]);
      text +=
          walk ? fmt::format("1,{},{},{}\n", walk->start.x, walk->start.y, walk->moves) : "0,,,\n";
    }
  }
  return text;
}

}  // namespace jaywalk::search
