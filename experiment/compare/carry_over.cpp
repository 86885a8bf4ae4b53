// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/carry_over.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace jaywalk {

TestOrder test_order(const Scenario& scenario) {
  return scenario.world->carries_over() ? TestOrder::chained : TestOrder::any;
}

CarryOver::CarryOver(const ExperimentPlan& plan)
    : plan_(plan), chains_(plan.behaviours.size() * plan.agents.size()) {}

std::size_t CarryOver::chain_of(const TestKey& test) const {
  const auto place = std::ranges::find(plan_.agents, test.agents) - plan_.agents.begin();
  return test.behaviour * plan_.agents.size() + static_cast<std::size_t>(place);
}

int CarryOver::head_start(const TestKey& test) const {
  if (test.number == 0) return 0;
  const Chain& chain = chains_[chain_of(test)];
  const auto before = chain.find(test.number - 1);
  assert(before != chain.end() && "tests of a chain run in the order of their numbers");
  return before->second;
}

void CarryOver::finished(const TestKey& test, int left_over) {
  Chain& chain = chains_[chain_of(test)];
  chain[test.number] = left_over;
  if (test.number > 0) chain.erase(test.number - 1);
}

std::optional<TestSetup> in_its_chain(const PreparedScenario& prepared, TestSetup setup,
                                      const std::function<Proceed()>& proceed) {
  if (test_order(prepared.scenario()) == TestOrder::any) return setup;
  TestRunner runner(prepared);
  TestSetup before = setup;
  for (before.test = 0; before.test < setup.test; ++before.test) {
    if (proceed() == Proceed::no) return std::nullopt;
    before.head_start = runner.run(before).left_over;
  }
  setup.head_start = before.head_start;
  return setup;
}

}  // namespace jaywalk
