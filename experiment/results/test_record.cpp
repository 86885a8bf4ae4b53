#include "experiment/results/test_record.h"

#include <algorithm>
#include <array>
#include <utility>

namespace jaywalk {
namespace {

constexpr std::array<std::string_view, 5> kVerdicts = {"none", "vacuous", "pass", "fail",
                                                       "unavoidable"};

}  // namespace

std::string_view name(AssessmentVerdict verdict) {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

std::optional<AssessmentVerdict> parse_assessment_verdict(std::string_view text) {
  const auto found = std::ranges::find(kVerdicts, text);
  if (found == kVerdicts.end()) return std::nullopt;
  return static_cast<AssessmentVerdict>(found - kVerdicts.begin());
}

TestRecord make_test_record(const TestCase& test, const TestResult& result,
                            const TrialResult& trial, Recording recording) {
  TestRecord record{.test = test,
                    .result = result,
                    .outcome = outcome_of(trial),
                    .recording = std::move(recording)};
  for (const AgentOutcome& outcome : trial.outcome.agents) {
    record.scores.push_back(
        {.cost = outcome.cost, .reward = outcome.reward, .actions = outcome.actions});
  }
  record.drops = trial.troubles.drops;
  return record;
}

}  // namespace jaywalk
