// A scenario from a C++ program: one test, then a comparison that is judged and kept in a store.
#include <cstdio>
#include <iostream>

#include <jaywalk/comparison.h>
#include <jaywalk/store.h>
#include <jaywalk/world.h>

namespace {

int fail(const jaywalk::Diagnostics& diagnostics) {
  std::cerr << diagnostics.render();
  return 2;
}

}  // namespace

int main() {
  std::cout << "the first of " << jaywalk::world_list().size() << " worlds is "
            << jaywalk::world_list().front().name << '\n';
  const auto scenario = jaywalk::RunnableScenario::read(
      JAYWALK_DATA_DIR "/scenarios/paper.yaml",
      {.behaviours = {"proximity", "election"}, .data_folder = JAYWALK_DATA_DIR});
  if (!scenario) return fail(scenario.diagnostics());
  const auto rules =
      jaywalk::JudgingRules::read({JAYWALK_DATA_DIR "/scenarios/assertions/crossing.yaml"});
  if (!rules) return fail(rules.diagnostics());

  const auto test =
      scenario.value().run({.behaviour = "proximity", .agents = 2, .test = 1}, rules.value());
  if (!test) return fail(test.diagnostics());
  std::cout << "test 1 ended by " << test.value().ended_by << " after " << test.value().ticks
            << " ticks; the AV was last at y = " << test.value().actors[0].moments.back().y_m
            << " m\n";

  std::remove(STORE);
  const auto report = jaywalk::compare(scenario.value(), {.tests = 20,
                                                          .agents = {{1, 2}},
                                                          .threads = 2,
                                                          .rules = rules.value().with_metrics(true),
                                                          .store = STORE});
  if (!report) return fail(report.diagnostics());
  for (const jaywalk::ComparisonRow& row : report.value().rows) {
    std::cout << row.behaviour << ", " << row.agents << ": " << row.successes << " of " << row.tests
              << ", accuracy " << row.measure("accuracy").value.value_or(0) << " %\n";
  }

  const auto store = jaywalk::ResultsStore::open(STORE);
  if (!store) return fail(store.diagnostics());
  std::int64_t failing = 0;
  (void)store.value().for_each_test({.behaviour = "election"}, [&](const jaywalk::TestLine& line) {
    failing = line.id;
    return line.succeeded;
  });
  const auto seen = store.value().test(failing);
  if (!seen) return fail(seen.diagnostics());
  for (const jaywalk::TestVerdict& verdict : seen.value().verdicts) {
    std::cout << verdict.assertion << ": " << name(verdict.verdict) << '\n';
  }
}
