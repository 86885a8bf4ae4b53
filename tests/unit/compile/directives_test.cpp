// SPDX-License-Identifier: Apache-2.0
// Directives of programs: includes, namespaces, functions, and unknown ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;
using testing::ElementsAre;

TEST(Directives, SuggestTheNameThatWasMeant) {
  EXPECT_EQ(CompiledProgram("{inlcude(\"a.asl\")}").errors(),
            "1:2: there is no directive 'inlcude' [did you mean 'include'?]\n");
  EXPECT_EQ(CompiledProgram("{begin bgd(g)} +!g. {end}").errors(),
            "1:8: there is no directive 'bgd' [did you mean 'bdg'?]\n");
  EXPECT_EQ(CompiledProgram("{quite_another(1)}").errors(),
            "1:2: there is no directive 'quite_another'\n");
}

TEST(Directives, IncludeWhatStandsThereInItsPlace) {
  EXPECT_THAT(CompiledProgram("a. {include(\"o.asl\")} c.", {}, {{"o.asl", "b."}}).beliefs(),
              ElementsAre("a[source(self)]", "b[source(self)]", "c[source(self)]"));
}

TEST(Directives, IncludeAFileInTheNamespaceThatTheySay) {
  const CompiledProgram made("{include(\"o.asl\", n)} {include(\"o.asl\", n)} a.", {},
                             {{"o.asl", "b(c). default::d."}});
  EXPECT_THAT(made.beliefs(),
              ElementsAre("n::b(c)[source(self)]", "d[source(self)]", "n::b(c)[source(self)]",
                          "d[source(self)]", "a[source(self)]"));
}

TEST(Directives, IncludeAFileInANamespaceOfItsOwnForEachVariable) {
  const CompiledProgram made("{include(\"o.asl\", N)} {include(\"o.asl\", M)}", {},
                             {{"o.asl", "b."}});
  EXPECT_THAT(made.beliefs(), ElementsAre("ns1::b[source(self)]", "ns2::b[source(self)]"));
}

TEST(Directives, KeepTheFileOfEachPlan) {
  const CompiledProgram made("+!a. {include(\"o.asl\")} +!c.", {}, {{"o.asl", "+!b."}});
  std::vector<std::string> files;
  for (const auto& plan : made.plans()) files.push_back(plan->file);
  EXPECT_THAT(files, ElementsAre("agent.asl", "o.asl", "agent.asl"));
}

TEST(Directives, TakeAnEqualPlanOfTwoIncludesOnce) {
  const CompiledProgram made("{include(\"o.asl\")} {include(\"o.asl\")}", {},
                             {{"o.asl", "@l +!a."}});
  EXPECT_EQ(made.errors(), "");
  EXPECT_EQ(made.plans().size(), 1U);
}

TEST(Directives, PutABlockIntoANamespace) {
  EXPECT_THAT(
      CompiledProgram("a. {begin namespace(n)} b. {begin namespace(m)} c. {end} d. {end} e.")
          .beliefs(),
      ElementsAre("a[source(self)]", "n::b[source(self)]", "m::c[source(self)]",
                  "n::d[source(self)]", "e[source(self)]"));
}

TEST(Directives, HideALocalNamespaceFromWhoWritesItsNameElsewhere) {
  const CompiledProgram made("{begin namespace(n, local)} b. n::c. {end}");
  EXPECT_THAT(made.beliefs(), ElementsAre("#1n::b[source(self)]", "#1n::c[source(self)]"));
}

TEST(Directives, GiveALocalNamespaceOneNameInAFile) {
  const CompiledProgram made(
      "{begin namespace(n, local)} b. {end} {begin namespace(n, local)} b. {end} "
      "{begin namespace(n, global)} b. {end}");
  EXPECT_THAT(made.beliefs(),
              ElementsAre("#1n::b[source(self)]", "#1n::b[source(self)]", "n::b[source(self)]"));
}

TEST(Directives, WantTheNameOfANamespace) {
  EXPECT_EQ(CompiledProgram("{begin namespace(\"n\")} b. {end}").errors(),
            "1:8: expected a name, as in namespace(n)\n");
  EXPECT_EQ(CompiledProgram("{begin namespace} b. {end}").errors(),
            "1:8: expected a name, as in namespace(n)\n");
}

TEST(Directives, RegisterFunctionsForTermsThatStandBefore) {
  const CompiledProgram made(
      "+!g : b(X) <- Y = my.twice(X).\n"
      "{register_function(\"my.twice\", 1, \"double\")}\n"
      "double(X, Y) :- Y = 2 * X.");
  EXPECT_EQ(made.errors(), "");
  const auto& functions = made.program->functions();
  ASSERT_EQ(functions.size(), 1U);
  EXPECT_EQ(functions[0].arity, 1U);
  EXPECT_EQ(made.symbols.signature(functions[0].predicate).arity, 2U);
  const Value term = made.plan().code.entry->steps.front().term;
  EXPECT_TRUE(is_form(term.structure()->arg(1), Form::function));
}

TEST(Directives, RefuseFunctionsThatAreWrittenInJava) {
  EXPECT_EQ(
      CompiledProgram("{register_function(\"my.Function\")}").errors(),
      "1:2: the function 'my.Function' is a Java class [run with --jason PATH (see "
      "docs/guides/from_jason.md), or define it by a rule: register_function(\"my.f\", Arity, "
      "\"pred\")]\n");
}

}  // namespace
}  // namespace jaywalk
