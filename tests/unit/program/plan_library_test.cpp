// SPDX-License-Identifier: Apache-2.0
// Which plans a library finds for an event, and in which order.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/logic/beliefs/belief_base.h"
#include "interpreter/program/plan.h"
#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;
using testing::ElementsAre;
using testing::IsEmpty;

/// The lines of the plans that the library finds for an event.
class PlansFor {
 public:
  explicit PlansFor(const std::string& program) : made_(program) {
    for (const auto& plan : made_.plans()) library_.add(plan);
  }

  [[nodiscard]] std::vector<std::uint32_t> lines(TriggerOperator op, TriggerKind kind,
                                                 std::string_view name, std::uint16_t arity) {
    std::vector<std::uint32_t> lines;
    const TriggerKey key{op, kind, made_.symbols.predicate(name, arity)};
    for (const Plan* plan : library_.candidates(key)) lines.push_back(plan->line);
    return lines;
  }
  [[nodiscard]] std::vector<std::uint32_t> for_goal(std::string_view name,
                                                    std::uint16_t arity = 0) {
    return lines(TriggerOperator::add, TriggerKind::achieve, name, arity);
  }
  [[nodiscard]] std::shared_ptr<const Plan> plan(std::size_t at) const { return made_.plans()[at]; }
  PlanLibrary& library() { return library_; }

 private:
  CompiledProgram made_;
  PlanLibrary library_;
};

TEST(PlanLibrary, FindsPlansByOperatorKindAndPredicateInOrder) {
  PlansFor found("+!g.\n+g.\n-!g.\n+!g(X).\n+!g : b.\n+?g.\n");
  EXPECT_THAT(found.for_goal("g"), ElementsAre(1, 5));
  EXPECT_THAT(found.for_goal("g", 1), ElementsAre(4));
  EXPECT_THAT(found.for_goal("h"), IsEmpty());
  EXPECT_THAT(found.lines(TriggerOperator::add, TriggerKind::belief, "g", 0), ElementsAre(2));
  EXPECT_THAT(found.lines(TriggerOperator::remove, TriggerKind::achieve, "g", 0), ElementsAre(3));
  EXPECT_THAT(found.lines(TriggerOperator::add, TriggerKind::test, "g", 0), ElementsAre(6));
}

TEST(PlanLibrary, PutsPlansForAnyPredicateAmongThoseOfEachInTheirOrder) {
  PlansFor found("+!X.\n+!g.\n+!X : b.\n+!g.\n+X.\n");
  EXPECT_THAT(found.for_goal("g"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(found.for_goal("other"), ElementsAre(1, 3));
  EXPECT_THAT(found.lines(TriggerOperator::add, TriggerKind::belief, "g", 0), ElementsAre(5));
  EXPECT_THAT(found.lines(TriggerOperator::remove, TriggerKind::belief, "g", 0), IsEmpty());
}

TEST(PlanLibrary, AddsAPlanBeforeTheOthers) {
  PlansFor found("+!g.\n+!X.\n+!g.\n");
  const auto last = found.plan(2);
  found.library().remove(*last);
  EXPECT_THAT(found.for_goal("g"), ElementsAre(1, 2));
  found.library().add_first(last);
  EXPECT_THAT(found.for_goal("g"), ElementsAre(3, 1, 2));
}

TEST(PlanLibrary, ForgetsAPlanThatIsRemoved) {
  PlansFor found("+!g.\n+!X.\n+!g.\n");
  found.library().remove(*found.plan(1));
  EXPECT_THAT(found.for_goal("g"), ElementsAre(1, 3));
  EXPECT_THAT(found.for_goal("other"), IsEmpty());
  found.library().remove(*found.plan(1));
  EXPECT_EQ(found.library().plans().size(), 2U) << "it was gone already";
}

TEST(PlanLibrary, CountsThePlansOfKindsThatCostTimeElsewhere) {
  PlansFor found("^!g.\n+b.\n@l[learned(p)] +!g.\n+!kqml_received(_, _, _, _).\n");
  PlanLibrary& library = found.library();
  EXPECT_TRUE(library.has_goal_state_plans());
  EXPECT_TRUE(library.has_belief_plans());
  EXPECT_TRUE(library.has_learned_plans());
  EXPECT_TRUE(library.has_own_message_plans());
  EXPECT_TRUE(library.list(found.plan(2)->key).has_learned());
  for (std::size_t i = 0; i < 4; ++i) library.remove(*found.plan(i));
  EXPECT_FALSE(library.has_goal_state_plans());
  EXPECT_FALSE(library.has_belief_plans());
  EXPECT_FALSE(library.has_learned_plans());
  EXPECT_FALSE(library.has_own_message_plans());
}

/// The lines of the plans of the list that may match a first argument, until one is `last`.
std::vector<std::uint32_t> looked_at(const PlanList& list, std::uint64_t key,
                                     std::uint32_t last = 0) {
  std::vector<std::uint32_t> lines;
  const bool found = list.find(key, [&](const Plan& plan) {
    lines.push_back(plan.line);
    return plan.line == last;
  });
  EXPECT_EQ(found, last != 0);
  return lines;
}

/// Plans whose first arguments are 0, 1, 2, and any, again and again.
std::string plans_of_first_arguments(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += "+!g(" + (i % 4 == 3 ? "X" : std::to_string(i % 4)) + ").\n";
  }
  return text;
}

TEST(PlanList, LooksAtThePlansThatMayMatchTheFirstArgumentAlone) {
  // Few plans are looked through; many are found by an index. Both ways find the same.
  for (const int count : {8, 9, 40}) {
    PlansFor found(plans_of_first_arguments(count));
    const PlanList& list = found.library().list(found.plan(0)->key);
    EXPECT_EQ(list.is_short(), count == 8);
    std::vector<std::uint32_t> expected;
    std::vector<std::uint32_t> wild;
    std::vector<std::uint32_t> all;
    for (int i = 0; i < count; ++i) {
      const auto line = static_cast<std::uint32_t>(i + 1);
      if (i % 4 == 1 || i % 4 == 3) expected.push_back(line);
      if (i % 4 == 3) wild.push_back(line);
      all.push_back(line);
    }
    EXPECT_EQ(looked_at(list, argument_key(Value::number(1))), expected) << count;
    EXPECT_EQ(looked_at(list, argument_key(Value::number(77))), wild) << count;
    EXPECT_EQ(looked_at(list, 0), all) << count;
    EXPECT_THAT(looked_at(list, argument_key(Value::number(1)), 4), ElementsAre(2, 4)) << count;
  }
}

}  // namespace
}  // namespace jaywalk
