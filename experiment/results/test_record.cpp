#include "experiment/results/test_record.h"

#include <algorithm>
#include <array>
#include <utility>

namespace jaywalk {
namespace {

constexpr std::array<std::string_view, 5> kVerdicts = {"none", "vacuous", "pass", "fail",
                                                       "unavoidable"};

}  // namespace

std::string_view name(StoredVerdict verdict) {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

std::optional<StoredVerdict> parse_stored_verdict(std::string_view text) {
  const auto found = std::ranges::find(kVerdicts, text);
  if (found == kVerdicts.end()) return std::nullopt;
  return static_cast<StoredVerdict>(found - kVerdicts.begin());
}

TestRecord make_test_record(const TestKey& test, const TestResult& result, const TestRun& run,
                            Recording recording) {
  TestRecord record{.test = test,
                    .result = result,
                    .outcome = outcome_of(run),
                    .recording = std::move(recording)};
  for (const AgentOutcome& outcome : run.outcome.agents) {
    record.scores.push_back(
        {.cost = outcome.cost, .reward = outcome.reward, .actions = outcome.actions});
  }
  record.drops = run.troubles.drops;
  return record;
}

}  // namespace jaywalk
