// SPDX-License-Identifier: Apache-2.0
// Every agent has the plans for messages: they come after its own and cannot be replaced by labels.

#include "interpreter/compile/kqml_plans.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;

TEST(KqmlPlans, StandAfterThoseOfTheProgram) {
  const CompiledProgram made("+!kqml_received(S, tell, C, _) <- .print(C). +!g.");
  const auto& plans = made.program->library().plans();
  ASSERT_GT(plans.size(), 10U);
  EXPECT_FALSE(plans[0]->is_standard);
  EXPECT_FALSE(plans[1]->is_standard);
  for (std::size_t i = 2; i < plans.size(); ++i) EXPECT_TRUE(plans[i]->is_standard) << i;
  const auto& first = made.program->library().candidates(plans[0]->key);
  EXPECT_EQ(first.front(), plans[0].get());
}

TEST(KqmlPlans, HandleEachPerformative) {
  const CompiledProgram made("");
  std::set<std::string> handled;
  for (const auto& plan : made.program->library().plans()) {
    const std::span<const Value> args = literal_parts(plan->trigger).args;
    if (args.size() == 4 && args[1].is_atom()) handled.insert(made.text(args[1]));
  }
  EXPECT_EQ(handled, (std::set<std::string>{"tell", "untell", "achieve", "unachieve", "askOne",
                                            "askAll", "tellHow", "untellHow", "askHow", "signal"}));
}

TEST(KqmlPlans, AreInTheDefaultNamespaceWhateverTheProgramsIs) {
  const CompiledProgram made("b.", {.ns = "n"});
  for (const auto& plan : made.program->library().plans()) {
    EXPECT_EQ(made.symbols.signature(plan->key.predicate).ns, names::default_ns);
  }
}

TEST(KqmlPlans, TakeNoLabelFromTheProgram) {
  EXPECT_EQ(CompiledProgram("@kqmlReceivedTellStructure +!g <- a.").errors(), "");
}

TEST(KqmlPlans, AreNoPlansOfTheProgramsOwnForMessages) {
  EXPECT_FALSE(CompiledProgram("+!g.").program->library().has_own_message_plans());
  EXPECT_TRUE(
      CompiledProgram("+!kqml_received(_, _, _, _).").program->library().has_own_message_plans());
}

}  // namespace
}  // namespace jaywalk
