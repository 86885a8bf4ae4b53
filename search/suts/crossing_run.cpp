// SPDX-License-Identifier: Apache-2.0
#include "search/suts/crossing_run.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/compare/carry_over.h"
#include "experiment/compare/kills/kills.h"
#include "experiment/judge/metrics/metrics.h"
#include "experiment/policy/policy.h"
#include "search/sut.h"

namespace jaywalk::search {
namespace {

/// The value of a metric or a robustness that does not exist or is infinite.
constexpr double kNone = 1e6;
/// The number of a pedestrian's last ticks that make a test's signature.
constexpr std::size_t kSignatureTicks = 8;

double bounded(double value) { return std::clamp(value, -kNone, kNone); }

/// The share of the pedestrians' steps that a person might take: not straight back, and not
/// standing still in the road.
double share_of_natural_steps(const TestView& view) {
  double steps = 0;
  double natural = 0;
  for (const ActorIndex actor : view.road_users()) {
    for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
      steps += 1;
      if (is_natural_step(view, actor, tick)) natural += 1;
    }
  }
  return steps > 0 ? natural / steps : 1;
}

/// The last seconds of the pedestrian that is nearest to the AV at the end, seen from the AV.
std::vector<double> last_approach(const TestView& view) {
  std::vector<double> numbers(2 * kSignatureTicks);
  if (view.road_users().empty()) return numbers;
  const ActorIndex actor = view.nearest().back();
  for (std::size_t i = 0; i < kSignatureTicks; ++i) {
    const std::size_t tick = view.ticks() - 1 - std::min(i, view.ticks() - 1);
    const ActorState& av = view.state(kAv, tick);
    const ActorState& other = view.state(actor, tick);
    numbers[2 * i] = other.x_m - av.x_m;
    numbers[2 * i + 1] = other.y_m - av.y_m;
  }
  return numbers;
}

std::string first_of(const Diagnostics& diagnostics) {
  return diagnostics.empty() ? "the test cannot be run" : diagnostics.items().front().message;
}

/// How near the AV came to a failure: a test that cannot fail, since no driver could have kept the
/// requirement, is not near one.
double margin(const Judgement& judgement) {
  const bool can_fail = judgement.verdict == Verdict::fail || !judgement.excused;
  if (!judgement.robustness || !can_fail) return kNone;
  return bounded(*judgement.robustness);
}

}  // namespace

Result<Scenario> scenario_of(const CrossingSettings& settings,
                             const std::vector<std::string>& sets) {
  ScenarioOptions options{.sets = sets, .files = settings.files, .include = settings.include};
  if (!settings.policies.empty()) {
    options.sets.push_back(fmt::format("policy={}", nlohmann::json(settings.policies).dump()));
  }
  options.sets.insert(options.sets.end(), settings.limits.begin(), settings.limits.end());
  if (!settings.behaviour.empty()) options.behaviours = {settings.behaviour};
  Result<Scenario> scenario = parse_scenario(settings.scenario, options);
  if (scenario.ok()) scenario.value().experiment.defects = settings.defects;
  return scenario;
}

std::optional<std::string> objection_to(const SourcePtr& policy, const PreparedScenario& prepared) {
  const auto plans = learned_plans(*prepared.behaviours().front().program, *prepared.symbols());
  if (plans.empty()) return std::string();
  const auto parsed = parse_policy(policy);
  if (!parsed.ok()) return first_of(parsed.diagnostics());
  std::string why = mismatch(*parsed.value(), plans);
  if (why.empty()) return std::nullopt;
  return fmt::format("{}: {}", prepared.behaviours().front().name, why);
}

CrossingMeasures::CrossingMeasures(const CrossingSettings& settings) {
  for (const Assertion& assertion : settings.assertions) {
    for (const char* what : {"exercised", "robustness", "margin"}) {
      names_.push_back(fmt::format("{}_{}", assertion.id, what));
    }
  }
  const std::size_t assertions = names_.size();
  std::ranges::move(situation_measures(), std::back_inserter(names_));
  kinds_ = {{"exercised", "1 if the precondition was met, else less the farther all stayed away"},
            {"precondition", "1 if the precondition of the AV's assertion was met, else 0"},
            {"naturalness", "share of steps that a person might take, 0 to 1"},
            {"new_bins", "bins of situations that no test of the search met before"},
            {"rarity", "mean of 1 / (1 + tests that met it before) over the bins it met, 0 to 1"}};
  for (std::size_t i = assertions; i < names_.size(); ++i) {
    kinds_.push_back({names_[i], "the bin of that situation, from 1; 0: none"});
  }
  if (settings.metrics) {
    for (const Metric& metric : metrics()) kinds_.push_back({metric.name, metric.formula});
  }
  for (std::size_t i = 0; i < assertions; ++i) kinds_.push_back({names_[i], "of the assertion"});
  if (settings.assertions.empty()) return;
  kinds_.push_back({"blamed", "1 if the AV is to blame for a broken assertion, else 0"});
  if (settings.defects.empty()) return;
  kinds_.push_back({"kills", "1 if it is with its defect, and would not be without, else 0"});
  kinds_.push_back({"healthy_blamed", "1 if it would be without its defect, too, else 0"});
}

/// A test that was run.
struct CrossingRun::Seen {
  TestRun result;
  Recording recording;
  std::vector<Judgement> judgements;
};

/// Makes the scenario ready; empty, or why it cannot be.
std::string CrossingRun::prepare(const TestInput& input) {
  std::vector<std::string> sets = space_.world_settings(input);
  // Programs are compiled again only if the world changes; starts and parameters are the test's
  // own.
  if (prepared_ != nullptr && sets == sets_) return {};
  Result<Scenario> scenario = scenario_of(settings_, space_.settings(input));
  if (!scenario.ok()) return first_of(scenario.diagnostics());
  if (test_order(scenario.value()) == TestOrder::chained) {
    return "world.av.carry_over: a test that is searched has none before it";
  }
  Diagnostics warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  if (!prepared.ok()) return first_of(prepared.diagnostics());
  sets_ = std::move(sets);
  runner_ = nullptr;  // it refers to the scenario
  prepared_ = std::move(prepared).value();
  runner_ = std::make_unique<TestRunner>(*prepared_);
  ground_ = prepared_->scenario().world->ground();
  return {};
}

CrossingRun::Seen CrossingRun::see(const TestSetup& setup) {
  Seen seen;
  seen.result = runner_->run(setup, {.record = &seen.recording, .interrupted = stopped()});
  if (!seen.result.completed) return seen;
  const TestView view(seen.recording, ground_);
  for (const Assertion& assertion : settings_.assertions) {
    seen.judgements.push_back(judge(assertion, view));
  }
  return seen;
}

Outcome CrossingRun::run(const TestInput& input, std::size_t) {
  if (std::string why = prepare(input); !why.empty()) return {.error = std::move(why)};
  TestSetup setup{.agents = settings_.agents,
                  .seed = seed(input),
                  .test = 0,
                  .feedback = feedback_,
                  .vehicle = settings_.vehicle,
                  .starts = space_.starts(input),
                  .parameters = space_.parameters(input)};
  if (std::string why = problem(*prepared_, setup); !why.empty()) return {.error = std::move(why)};
  const Seen seen = see(setup);
  if (!seen.result.completed) return {.error = seen.result.message};
  Outcome outcome = measured(seen);
  if (settings_.assertions.empty()) return outcome;
  const bool blamed = blames_the_av(seen.judgements);
  outcome.measures.push_back(blamed ? 1 : 0);
  if (settings_.defects.empty()) return outcome;
  bool healthy_blamed = false;
  // Without blame there is no kill to confirm: the healthy twin need not run.
  if (blamed) {
    setup.vehicle = 0;
    const Seen healthy = see(setup);
    if (!healthy.result.completed) return {.error = healthy.result.message};
    healthy_blamed = blames_the_av(healthy.judgements);
  }
  outcome.measures.push_back(blamed && !healthy_blamed ? 1 : 0);
  outcome.measures.push_back(healthy_blamed ? 1 : 0);
  return outcome;
}

/// Chance is a function of the input, so that the same input always has the same outcome.
std::uint64_t CrossingRun::seed(const TestInput& input) const {
  std::uint64_t seed = settings_.seed;
  for (const double value : input.values) seed = mix(seed, std::bit_cast<std::uint64_t>(value));
  return seed;
}

void CrossingRun::remember(const Outcome& outcome) {
  if (outcome.executed()) cover(*situation_bins(outcome, measures_.kinds()));
}

/// Agents receive it as in comparisons (compare/feedback.h), all tests of a generation the
/// same.
void CrossingRun::cover(const SituationBins& bins) {
  covered_.add(bins);
  if (settings_.feedback == 0 || covered_.tests() % settings_.feedback != 0) return;
  feedback_ = feedback_of(covered_);
}

/// Adds the measures of situations.
void CrossingRun::measure_situations(const Recording& recording, Outcome& outcome) {
  const SituationBins bins = covered_bins(recording, ground_);
  const std::uint64_t before = covered_.covered();
  double rarity = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (!bins[i]) continue;
    rarity += 1 / (1 + static_cast<double>(covered_.counts()[i][*bins[i]]));
  }
  cover(bins);
  outcome.measures.push_back(static_cast<double>(covered_.covered() - before));
  outcome.measures.push_back(rarity / static_cast<double>(bins.size()));
  add_situations(bins, outcome.measures);
}

Outcome CrossingRun::measured(const Seen& seen) {
  const TestView view(seen.recording, ground_);
  const bool success = seen.result.outcome.success;
  Outcome outcome;
  outcome.simulated_s = static_cast<double>(view.ticks() - 1) * view.tick_s();
  const auto nearest = jaywalk::measured(*find_metric("min_distance"), view);
  const double distance = nearest ? nearest->value : kNone;
  // In the order of `kinds_`. Short of the precondition the measure falls with the distance, but
  // stays below 1.
  outcome.measures = {success ? 1 : 0.9 / (1 + distance / 5), success ? 1.0 : 0.0,
                      share_of_natural_steps(view)};
  measure_situations(seen.recording, outcome);
  for (const Metric& metric : settings_.metrics ? metrics() : std::span<const Metric>()) {
    const auto value = jaywalk::measured(metric, view);
    // A metric that does not apply counts as harmless: beyond all values where the least is worst.
    const double missing = metric.worst == Worst::least ? kNone : 0;
    outcome.measures.push_back(value ? bounded(value->value) : missing);
  }
  for (const Judgement& judgement : seen.judgements) {
    outcome.measures.push_back(bounded(judgement.exercised));
    outcome.measures.push_back(judgement.robustness ? bounded(*judgement.robustness) : kNone);
    outcome.measures.push_back(margin(judgement));
  }
  outcome.signature = last_approach(view);
  return outcome;
}

}  // namespace jaywalk::search
