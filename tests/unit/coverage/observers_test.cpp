// SPDX-License-Identifier: Apache-2.0
// Several observers that stand where one is expected.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/logic/action.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsSupersetOf;

/// Writes down what it sees, after its name.
class Witness final : public ReasoningObserver {
 public:
  Witness(std::string name, std::vector<std::string>& seen) : name_(std::move(name)), seen_(seen) {}

  [[nodiscard]] bool interrupted() override { return interrupts; }
  void event_selected(Agent&, const Event&) override { note("selected"); }
  void plan_relevant(Agent&, const Plan&, const Event&, std::span<const Value>) override {
    note("relevant");
  }
  void plan_tried(Agent&, const Plan&, bool) override { note("tried"); }
  void plan_chosen(Agent&, const Plan&, const Event&, const Intention&) override { note("chosen"); }
  void no_plan(Agent&, const Event&, bool had_candidates) override {
    note(had_candidates ? "not applicable" : "no plan");
  }
  void formula_executes(Agent&, const Intention&, const Step&) override { note("executes"); }
  void formula_failed(Agent&, const Intention&, const ActionError&) override { note("failed"); }
  void event_posted(Agent&, const Event&) override { note("posted"); }

  bool interrupts = false;

 private:
  void note(const std::string& what) { seen_.push_back(name_ + ": " + what); }

  std::string name_;
  std::vector<std::string>& seen_;
};

void run(ReasoningObserver& observer, std::string_view program) {
  test::System system;
  system.options.observer = &observer;
  system.add("agent", program);
  (void)system.run();
}

TEST(Observers, AreNobodyOrTheOnlyOneOrAllOfThem) {
  std::vector<std::string> seen;
  Witness a("a", seen);
  Witness b("b", seen);
  Observers observers;
  EXPECT_EQ(observers.get(), nullptr);
  observers.add(a);
  EXPECT_EQ(observers.get(), &a);
  observers.add(b);
  EXPECT_EQ(observers.get(), &observers);
}

TEST(Observers, ReceiveEveryCallInTheOrderInWhichTheyWereAdded) {
  std::vector<std::string> seen;
  Witness a("a", seen);
  Witness b("b", seen);
  Observers observers;
  observers.add(a);
  observers.add(b);
  run(observers, "!g. +!g : true <- !h; !i. +!h : no. -!h <- .fail. ");
  ASSERT_EQ(seen.size() % 2, 0U);
  for (std::size_t i = 0; i < seen.size(); i += 2) {
    EXPECT_EQ("b" + seen[i].substr(1), seen[i + 1]) << "after " << seen[i];
  }
  EXPECT_THAT(seen, IsSupersetOf({"a: posted", "a: selected", "a: relevant", "a: tried",
                                  "a: chosen", "a: executes", "a: failed", "a: not applicable"}));
  // An observer sees the same alone as among others.
  std::vector<std::string> alone;
  Witness only("a", alone);
  run(only, "!g. +!g : true <- !h; !i. +!h : no. -!h <- .fail. ");
  std::erase_if(seen, [](const std::string& each) { return each.front() == 'b'; });
  EXPECT_EQ(seen, alone);
}

TEST(Observers, InterruptIfOneOfThemDoes) {
  std::vector<std::string> seen;
  Witness a("a", seen);
  Witness b("b", seen);
  Observers observers;
  observers.add(a);
  observers.add(b);
  EXPECT_FALSE(observers.interrupted());
  b.interrupts = true;
  EXPECT_TRUE(observers.interrupted());
}

}  // namespace
}  // namespace jaywalk
