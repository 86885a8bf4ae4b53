// SPDX-License-Identifier: Apache-2.0
// The interpreter within another program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <jaywalk/interpreter.h>
#include <jaywalk/observer.h>

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Embedded : public testing::Test {
 protected:
  AgentId add(const std::string& name, const std::string& text) {
    const auto program = interpreter.load_text(name + ".asl", text);
    EXPECT_TRUE(program) << program.diagnostics().render();
    return interpreter.add_agent(name, program.value());
  }
  std::vector<std::string> ask(AgentId agent, const std::string& query) {
    std::vector<std::string> texts;
    const auto answers = interpreter.ask(agent, query);
    if (!answers) return {answers.diagnostics().render()};
    for (const Answer& answer : answers.value()) {
      std::string text;
      for (const Answer::Binding& binding : answer.bindings()) {
        text += binding.variable + "=" + binding.term + " ";
      }
      texts.push_back(text);
    }
    return texts;
  }

  std::vector<std::string> printed;
  Interpreter interpreter{{.max_cycles = 10'000,
                           .print = [this](std::string_view line) { printed.emplace_back(line); }}};
};

TEST_F(Embedded, RunsAProgram) {
  add("ann", "!g. +!g <- .print(hello).");
  EXPECT_EQ(interpreter.run().end, RunEnd::idle);
  EXPECT_THAT(printed, ElementsAre("[ann] hello"));
}

TEST_F(Embedded, SaysWhereAProgramIsWrong) {
  const auto program = interpreter.load_text("ann.asl", "p(1).\n+!g <- ).");
  ASSERT_FALSE(program);
  EXPECT_THAT(program.diagnostics().render(), HasSubstr("ann.asl:2:8: error: "));
}

TEST_F(Embedded, RefusesAFileThatIsNotThere) {
  const auto program = interpreter.load_file("no/such/file.asl");
  ASSERT_FALSE(program);
  EXPECT_THAT(program.diagnostics().render(), HasSubstr("no/such/file.asl"));
}

TEST_F(Embedded, AnswersQueries) {
  const AgentId ann = add("ann", "p(1). p(\"two\"). p(f(X)) :- X = [a]. q(3).");
  EXPECT_THAT(ask(ann, "p(X)"), ElementsAre("X=1 ", "X=\"two\" ", "X=f([a]) "));
  EXPECT_THAT(ask(ann, "q(B) & p(A) & A < B"), ElementsAre("B=3 A=1 "));
  EXPECT_THAT(ask(ann, "not p(9)"), ElementsAre(""));
  EXPECT_THAT(ask(ann, "p(9)"), IsEmpty());
  EXPECT_THAT(ask(ann, "X = Y"), ElementsAre(""));
  EXPECT_THAT(ask(ann, ".length([a,b], N)"), ElementsAre("N=2 "));
}

TEST_F(Embedded, GivesNumbersAndTexts) {
  const AgentId ann = add("ann", "p(1.5, \"a\").");
  const auto answers = interpreter.ask(ann, "p(N, T)");
  ASSERT_TRUE(answers);
  const Answer& answer = answers.value().at(0);
  EXPECT_EQ(answer.find("N")->number, 1.5);
  EXPECT_EQ(answer.find("T")->text, "a");
  EXPECT_EQ(answer["T"], "\"a\"");
  EXPECT_EQ(answer.find("X"), nullptr);
  EXPECT_EQ(answer["X"], "");
}

TEST_F(Embedded, StopsAfterTheAnswersAskedFor) {
  const AgentId ann = add("ann", "n(0). n(N) :- n(M) & N = M + 1.");
  const auto answers = interpreter.ask(ann, "n(N)", 3);
  ASSERT_TRUE(answers);
  EXPECT_EQ(answers.value().size(), 3U);
}

TEST_F(Embedded, RefusesWhatIsNoFormula) {
  const AgentId ann = add("ann", "p(1).");
  EXPECT_THAT(ask(ann, "p(X) &"), ElementsAre(HasSubstr("query:1:7: error: ")));
  EXPECT_THAT(ask(ann, "3"), ElementsAre(HasSubstr("query:1:1: error: expected a formula")));
  EXPECT_THAT(ask(ann, ""), ElementsAre(HasSubstr("query:1:1: error: ")));
}

TEST_F(Embedded, EndsAQueryThatWouldNeverEnd) {
  Interpreter limited({.max_inferences = 1000});
  const auto program = limited.load_text("ann", "p(X) :- p(X).");
  const AgentId ann = limited.add_agent("ann", program.value());
  const auto answers = limited.ask(ann, "p(1)");
  ASSERT_FALSE(answers);
  EXPECT_THAT(answers.diagnostics().render(), HasSubstr("inferences"));
}

TEST_F(Embedded, TellsABeliefAndRunsAgain) {
  const AgentId ann =
      add("ann", "+speed(X)[source(S)] <- .print(X, S). -speed(X) <- .print(gone).");
  EXPECT_EQ(interpreter.run().end, RunEnd::idle);
  EXPECT_TRUE(interpreter.believe(ann, "speed(6 + 7)").empty());
  EXPECT_TRUE(interpreter.believe(ann, "speed(8)[source(radar)]").empty());
  EXPECT_EQ(interpreter.run().end, RunEnd::idle);
  EXPECT_TRUE(interpreter.forget(ann, "speed(_)[source(radar)]").empty());
  interpreter.run();
  EXPECT_THAT(printed, ElementsAre("[ann] 13self", "[ann] 8radar", "[ann] gone"));
  EXPECT_THAT(ask(ann, "speed(X)"), ElementsAre("X=13 "));
}

TEST_F(Embedded, GivesAGoal) {
  const AgentId ann = add("ann", "+!go(X)[source(self)] <- .print(X).");
  EXPECT_TRUE(interpreter.achieve(ann, "go(there)").empty());
  interpreter.run();
  EXPECT_THAT(printed, ElementsAre("[ann] there"));
}

TEST_F(Embedded, RefusesWhatIsNoLiteral) {
  const AgentId ann = add("ann", "");
  EXPECT_THAT(interpreter.believe(ann, "p(1").render(), HasSubstr("belief:1:"));
  EXPECT_THAT(interpreter.achieve(ann, "3").render(), HasSubstr("goal:1:1: error: "));
  EXPECT_THAT(interpreter.forget(ann, "X").render(), HasSubstr("belief:1:1: error: "));
}

TEST_F(Embedded, IncludesAText) {
  const AgentId ann = add("ann", "");
  EXPECT_TRUE(interpreter.include(ann, "more", "p(1). !g. +!g : p(X) <- .print(X).").empty());
  EXPECT_THAT(interpreter.include(ann, "bad", "p(").render(), HasSubstr("bad:1:"));
  interpreter.run();
  EXPECT_THAT(printed, ElementsAre("[ann] 1"));
}

TEST_F(Embedded, ManyBeliefsDoNotFillTheMemory) {
  Interpreter limited({.max_agent_bytes = std::uint64_t{1} << 20U});
  const auto program = limited.load_text("ann", "+p(_) <- -+last(1).");
  const AgentId ann = limited.add_agent("ann", program.value());
  for (int i = 0; i < 20'000; ++i) {
    const std::string belief = "p(\"" + std::to_string(i) + " is a text of some length\")";
    ASSERT_TRUE(limited.believe(ann, belief).empty()) << i;
    ASSERT_TRUE(limited.forget(ann, "p(_)").empty()) << i;
    ASSERT_TRUE(limited.ask(ann, "last(X) | X = 0")) << i;
    if (i % 100 == 0) limited.run();
  }
}

TEST_F(Embedded, HasActionsOfItsOwn) {
  double total = 0;
  interpreter.add_action("my.add", 1, 2, [&](Call& call) {
    if (!call.arg(0).is_number()) return call.wrong_argument(0, "a number");
    total += call.arg(0).as_number();
    return call.count() == 1 ? Outcome::succeeded : call.result(1, Value::number(total));
  });
  interpreter.add_action("my.upto", 2, 2, [](Call& call) {
    return call.each([i = 0.0, last = call.arg(0).as_number()](Call& inner) mutable {
      return i < last && inner.unify(1, Value::number(++i));
    });
  });
  interpreter.add_function(
      {.name = "my.twice",
       .least_args = 1,
       .most_args = 1,
       .function = [](std::span<const Value> args, Heap&, SymbolTable&, Value& result) {
         if (!args[0].is_number()) return false;
         result = Value::number(2 * args[0].as_number());
         return true;
       }});
  const AgentId ann = add("ann",
                          "!g. +!g <- my.add(3); my.add(4, T); .print(T, \" \", my.twice(T)); "
                          ".findall(X, my.upto(3, X), L); .print(L); !bad. "
                          "+!bad <- my.add(a). -!bad[error_msg(M)] <- .print(M).");
  interpreter.run();
  EXPECT_THAT(
      printed,
      ElementsAre(
          "[ann] 7 14", "[ann] [1,2,3]",
          "[ann] Wrong argument for internal action 'add': first argument must be a number"));
  EXPECT_THAT(ask(ann, "my.upto(2, X)"), ElementsAre("X=1 ", "X=2 "));
}

TEST_F(Embedded, OwnActionsStandBeforeBuiltInOnes) {
  interpreter.add_action(".print", 0, -1, [this](Call&) {
    printed.emplace_back("mine");
    return Outcome::succeeded;
  });
  add("ann", "!g. +!g <- .print(hello).");
  interpreter.run();
  EXPECT_THAT(printed, ElementsAre("mine"));
}

TEST_F(Embedded, ReadsAndMakesTerms) {
  interpreter.add_action("my.swap", 2, 2, [](Call& call) {
    const Terms terms = call.terms();
    const Value given = call.arg(0);
    EXPECT_TRUE(terms.is_literal(given));
    EXPECT_TRUE(terms.is_negated(given));
    EXPECT_EQ(terms.functor(given), "p");
    const std::vector<Value> args = terms.args(given);
    EXPECT_EQ(terms.text(args.at(0)), "a");
    EXPECT_EQ(terms.elements(args.at(1)).size(), 2U);
    EXPECT_EQ(terms.printed(terms.annotations(given).at(0)), "b(1)");
    EXPECT_EQ(terms.functor(args.at(1)), "");
    EXPECT_TRUE(terms.args(args.at(0)).empty());
    const Value made = terms.structure("q", {args.at(1), terms.string("s"), terms.atom("~r")},
                                       {terms.atom("y"), terms.atom("x"), terms.atom("y")});
    EXPECT_TRUE(terms.equal(made, made));
    EXPECT_FALSE(terms.equal(made, given));
    return call.result(1, made);
  });
  const AgentId ann = add("ann", "");
  EXPECT_THAT(ask(ann, "my.swap(~p(\"a\", [1, X])[b(1)], Y)"),
              ElementsAre("Y=q([1,X],\"s\",~r)[x,y] "));
}

TEST_F(Embedded, SuspendsAnIntentionUntilItIsResumed) {
  std::optional<std::uint32_t> waiting;
  interpreter.add_action("my.wait", 0, 0, [&](Call& call) {
    waiting = call.intention();
    return call.suspend("waiting");
  });
  const AgentId ann = add("ann", "!g. !h. +!g <- my.wait; .print(g). +!h <- .print(h).");
  EXPECT_EQ(interpreter.run().end, RunEnd::idle);
  EXPECT_THAT(printed, ElementsAre("[ann] h"));
  EXPECT_THAT(interpreter.intentions(ann), ElementsAre("g"));
  ASSERT_TRUE(waiting);
  EXPECT_TRUE(interpreter.resume(ann, *waiting).empty());
  interpreter.run();
  EXPECT_THAT(printed, ElementsAre("[ann] h", "[ann] g"));
  EXPECT_THAT(interpreter.resume(ann, *waiting).render(), HasSubstr("no intention"));
  // A context cannot wait.
  EXPECT_THAT(ask(ann, "my.wait"), IsEmpty());
  EXPECT_FALSE(waiting);
}

TEST(Observed, ReceivesWhatAgentsDo) {
  class Log : public Observer {
   public:
    void event_selected(AgentView agent, const EventView& event) override {
      seen.push_back("selected " + agent.terms().printed(event.literal));
    }
    void plan_chosen(AgentView agent, const EventView&, const std::string&,
                     const IntentionView& intention) override {
      seen.push_back("chosen " + agent.terms().printed(intention.label));
    }
    void no_plan(AgentView, const EventView& event) override {
      seen.emplace_back(event.kind == EventView::Kind::achievement_goal ? "no plan" : "?");
    }
    void formula_executes(AgentView, const IntentionView&, const std::string& formula) override {
      seen.push_back(formula);
    }
    void formula_failed(AgentView agent, const IntentionView&, const std::string& id,
                        const std::string&) override {
      seen.push_back(agent.name() + " fails: " + id);
    }
    std::vector<std::string> seen;
  };
  Log log;
  Interpreter observed({.observer = log.reasoning()});
  const auto program = observed.load_text("ann.asl", "!g(2). !none. @p +!g(X) <- +b(X); .fail.");
  ASSERT_TRUE(program);
  observed.add_agent("ann", program.value());
  observed.run();
  EXPECT_THAT(log.seen, testing::IsSupersetOf({HasSubstr("selected g(2)"), HasSubstr("chosen p"),
                                               HasSubstr("+b(2)"), HasSubstr("no plan"),
                                               HasSubstr("ann fails: ")}));
}

// Runs a program with an observer, or without one; returns what it prints.
std::vector<std::string> printed_by(std::string program, ReasoningObserver* observer) {
  std::vector<std::string> printed;
  Interpreter interpreter({.seed = 3,
                           .print = [&](std::string_view line) { printed.emplace_back(line); },
                           .observer = observer});
  const auto loaded = interpreter.load_text("ann.asl", std::move(program));
  if (!loaded) return {loaded.diagnostics().render()};
  interpreter.add_agent("ann", loaded.value());
  interpreter.run();
  return printed;
}

TEST(Observed, DrawTheSameRandomNumbers) {
  Observer observer;
  const std::string program =
      "!g. +!g <- .print(math.random); X = math.random(10); .print(X, math.random).";
  const std::vector<std::string> unobserved = printed_by(program, nullptr);
  ASSERT_EQ(unobserved.size(), 2U);
  EXPECT_NE(unobserved[0], unobserved[1]);
  EXPECT_EQ(printed_by(program, observer.reasoning()), unobserved);
}

TEST(Observed, EvaluateNoMoreThanOthers) {
  class Formulas : public Observer {
   public:
    void formula_executes(AgentView, const IntentionView&, const std::string& formula) override {
      seen.push_back(formula);
    }
    std::vector<std::string> seen;
  };
  Formulas observer;
  const std::string program = "!g. +!g <- ?(true | 1 div 0 > 1); .print(went_on).";
  EXPECT_THAT(printed_by(program, nullptr), ElementsAre("[ann] went_on"));
  EXPECT_THAT(printed_by(program, observer.reasoning()), ElementsAre("[ann] went_on"));
  EXPECT_THAT(observer.seen, ElementsAre(HasSubstr("1 div 0"), ".print(went_on)"));
}

TEST_F(Embedded, AddsAgentsWhenAllAreIdle) {
  add("ann", "+p[source(S)] <- .print(S).");
  interpreter.run();
  add("bob", "!g. +!g <- .send(ann, tell, p).");
  EXPECT_EQ(interpreter.run().end, RunEnd::idle);
  EXPECT_THAT(printed, ElementsAre("[ann] bob"));
}

TEST_F(Embedded, DoesNotGoOnAfterItWasStopped) {
  const AgentId ann = add("ann", "!g. +!g <- .stopMAS(0, 3). +!h <- .print(h).");
  EXPECT_EQ(interpreter.run().exit_code, 3);
  EXPECT_TRUE(interpreter.achieve(ann, "h").empty());
  EXPECT_EQ(interpreter.run().end, RunEnd::stopped);
  EXPECT_THAT(printed, IsEmpty());
}

}  // namespace
}  // namespace jaywalk
