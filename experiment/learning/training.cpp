// SPDX-License-Identifier: Apache-2.0
#include "experiment/learning/training.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "experiment/compare/experiment.h"
#include "experiment/scenario/files/portable_names.h"
#include "experiment/scenario/files/program_text.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

/// The largest number of points in the curve.
constexpr std::size_t kMostPoints = 500;

const PreparedBehaviour& behaviour_of(const TrainingPlan& plan) {
  return plan.prepared->behaviours()[plan.behaviour];
}

std::string texts_hash(const std::vector<SourcePtr>& sources) {
  std::string texts;
  for (const SourcePtr& source : sources) texts += fmt::format("{}\n", sha256(source->text()));
  return sha256(texts);
}

/// The specification with its weights in the order of a file, so that continuing a policy finds an
/// equal one.
LearningSpec spec_of(const Scenario& scenario) {
  LearningSpec spec = scenario.learning;
  std::ranges::sort(spec.reward.violation);
  std::ranges::sort(spec.reward.robustness);
  return spec;
}

PolicyOrigin origin_of(const TrainingPlan& plan) {
  const Scenario& scenario = plan.prepared->scenario();
  std::string texts = texts_hash(scenario.sources);
  for (const std::string& set : plan.sets) texts += '\n' + set;
  return {.behaviour = behaviour_of(plan).name,
          .program_sha256 = texts_hash(behaviour_of(plan).sources),
          .scenario = PortableNames({scenario.name}, scenario.files).in(scenario.name),
          .scenario_sha256 = sha256(texts),
          .agents = plan.agents,
          .seed = plan.seed,
          .spec = spec_of(scenario)};
}

}  // namespace

/// One test's contribution to the learning of its generation.
struct Training::Lesson {
  std::optional<EpisodeRecorder> episodes;
  Recording recording;
  WorldResult outcome;
  bool errored = false;
  bool interrupted = false;
  std::string message;
};

Result<std::shared_ptr<Policy>> new_policy(const TrainingPlan& plan) {
  const PreparedBehaviour& behaviour = behaviour_of(plan);
  const std::vector<LearnedPlans> plans =
      learned_plans(*behaviour.program, *plan.prepared->symbols());
  if (!plans.empty()) return std::make_shared<Policy>(origin_of(plan), plans);
  Diagnostics diagnostics;
  diagnostics.error(behaviour.program_path, "the program has no plan that is labelled learned(P)",
                    "@go[learned(step)] +!step <- move(forward). makes a plan an option of step");
  return diagnostics;
}

std::string why_not_the_same(const TrainingPlan& plan, const Policy& policy) {
  const PolicyOrigin now = origin_of(plan);
  const PolicyOrigin& then = policy.origin();
  if (now.behaviour != then.behaviour) return fmt::format("it is of {}", then.behaviour);
  if (now.program_sha256 != then.program_sha256) return "the program has been changed since";
  if (now.scenario_sha256 != then.scenario_sha256) return "the scenario is another one";
  if (now.agents != then.agents)
    return fmt::format("it learned with {}", counted(then.agents, "agent"));
  if (now.seed != then.seed) return fmt::format("it learned with seed {}", then.seed);
  if (now.spec != then.spec) return "it learned with other settings";
  return {};
}

Training::Training(TrainingPlan plan, std::shared_ptr<Policy> policy)
    : plan_(std::move(plan)),
      policy_(std::move(policy)),
      runners_(*plan_.prepared),
      ground_(plan_.prepared->scenario().world->ground()),
      discount_(
          std::pow(policy_->origin().spec.discount, plan_.prepared->scenario().world->tick_s())),
      covered_(policy_->origin().covered.begin(), policy_->origin().covered.end()) {}

void Training::run_test(std::uint64_t number, Lesson& lesson) {
  const LearningSpec& spec = policy_->origin().spec;
  lesson.episodes.emplace(*policy_, discount_);
  TickRewards rewards(spec, *lesson.episodes);
  const std::size_t vehicles = plan_.prepared->vehicles().size();
  const TestSetup setup{.behaviour = plan_.behaviour,
                        .agents = plan_.agents,
                        .seed = plan_.seed,
                        .test = number,
                        .vehicle = vehicles > 1 ? 1 + number % (vehicles - 1) : 0};
  const TestOptions options{.observe = [&](const World& world, const Mas&) { rewards.tick(world); },
                            .record = needs_recording(spec.reward) ? &lesson.recording : nullptr,
                            .policies = &*lesson.episodes,
                            .interrupted = plan_.interrupted};
  TestRun result = runners_.run(setup, options);
  notes_.add(number, result.notes);
  lesson.errored = !result.completed;
  lesson.interrupted = result.interrupted;
  lesson.message = std::move(result.message);
  lesson.outcome = std::move(result.outcome);
}

std::vector<Training::Lesson> Training::run_tests(std::uint64_t count, std::string& problem) {
  std::vector<Lesson> lessons(count);
  const std::uint64_t first = policy_->origin().tests;
  const ExperimentPlan tests{.behaviours = {behaviour_of(plan_).name},
                             .agents = {plan_.agents},
                             .tests = count,
                             .summed_up = false,
                             .threads = plan_.threads};
  const auto run = [&](const TestKey& test) -> Result<TestResult> {
    run_test(first + test.number, lessons[test.number]);
    return TestResult{};
  };
  const ExperimentOutcome outcome = run_experiment(tests, run, [&](const Progress&) {
    return plan_.interrupted && plan_.interrupted() ? Proceed::no : Proceed::yes;
  });
  const auto end = std::ranges::find(lessons, true, &Lesson::interrupted);
  if (!outcome.complete() || end != lessons.end()) {
    problem = "interrupted";
    return {};
  }
  return lessons;
}

std::string Training::learn(std::vector<Lesson>& lessons) {
  const LearningSpec& spec = policy_->origin().spec;
  PolicyOrigin& origin = policy_->origin();
  for (Lesson& lesson : lessons) {
    if (lesson.errored) {
      ++origin.errored;
      continue;
    }
    add_end_rewards(spec,
                    {.outcome = lesson.outcome,
                     .recording = lesson.recording,
                     .ground = ground_,
                     .assertions = plan_.prepared->scenario().assertions},
                    covered_, *lesson.episodes);
  }
  for (const LearnedPlans& part : policy_->plans()) {
    std::vector<Episode> generation;
    for (const Lesson& lesson : lessons) {
      if (lesson.errored) continue;
      for (Episode& episode : lesson.episodes->episodes(part.policy)) {
        const std::size_t found = episode.front().features.size();
        const std::size_t expected =
            policy_->features(part.policy)
                .value_or(generation.empty() ? found : generation.front().front().features.size());
        if (found != expected) {
          return fmt::format("observation({}, Features) has had {} numbers, now {}", part.policy,
                             expected, found);
        }
        generation.push_back(std::move(episode));
      }
    }
    policy_->learn(part.policy, generation);
  }
  origin.tests += lessons.size();
  origin.covered.assign(covered_.begin(), covered_.end());
  note_point(lessons);
  return {};
}

// If there are too many points, neighbours are merged.
void Training::note_point(const std::vector<Lesson>& lessons) {
  LearningPoint point{.tests = policy_->origin().tests};
  double counted = 0;
  for (const Lesson& lesson : lessons) {
    if (lesson.errored) continue;
    counted += 1;
    point.reward += lesson.episodes->mean_return();
    point.success_pct += lesson.outcome.success ? 100 : 0;
  }
  if (counted == 0) return;
  point.reward /= counted;
  point.success_pct /= counted;
  std::vector<LearningPoint>& curve = policy_->origin().curve;
  curve.push_back(point);
  if (curve.size() < kMostPoints) return;
  std::vector<LearningPoint> fewer;
  for (std::size_t i = 0; i + 1 < curve.size(); i += 2) {
    const double before = static_cast<double>(i == 0 ? 0 : curve[i - 1].tests);
    const double one = static_cast<double>(curve[i].tests) - before;
    const double two = static_cast<double>(curve[i + 1].tests - curve[i].tests);
    const auto mean = [&](double a, double b) { return (one * a + two * b) / (one + two); };
    fewer.push_back({.tests = curve[i + 1].tests,
                     .reward = mean(curve[i].reward, curve[i + 1].reward),
                     .success_pct = mean(curve[i].success_pct, curve[i + 1].success_pct)});
  }
  curve = std::move(fewer);
}

Training::End Training::run_generation(std::uint64_t most, std::string& problem) {
  const std::uint64_t count = std::min(most, policy_->origin().spec.generation);
  std::vector<Lesson> lessons = run_tests(count, problem);
  if (!problem.empty()) return End::interrupted;
  if (std::ranges::all_of(lessons, &Lesson::errored)) {
    problem = fmt::format("none of {} came to its end: {}", counted(count, "test"),
                          lessons.front().message);
    return End::failed;
  }
  problem = learn(lessons);
  return problem.empty() ? End::learned : End::failed;
}

}  // namespace jaywalk
