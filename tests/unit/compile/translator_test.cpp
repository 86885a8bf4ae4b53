// SPDX-License-Identifier: Apache-2.0
// Syntax trees to terms: variables, namespaces, operators, bodies.

#include "interpreter/compile/translator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/syntax/parser.h"
#include "interpreter/term/print.h"
#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;
using testing::ElementsAre;

class TranslatorTest : public testing::Test {
 protected:
  Value read(const std::string& text) {
    Diagnostics diagnostics;
    // Trees refer to their text.
    sources_.push_back(std::make_shared<const Source>("t", text));
    const ast::Node* const node = parse_term(sources_.back(), arena_, diagnostics);
    EXPECT_NE(node, nullptr) << diagnostics.render();
    return node == nullptr ? Value() : translator_.term(*node, scope_);
  }
  std::string text(const std::string& text) { return term_text(read(text), symbols_); }

  std::vector<SourcePtr> sources_;
  Heap heap_;
  SymbolTable symbols_;
  ast::Arena arena_;
  Translator translator_{heap_, symbols_, standard_actions()};
  VariableScope scope_{VariableScope::Kind::slots, heap_, symbols_};
};

TEST_F(TranslatorTest, TakesEqualNamesForOneVariableAndEachUnderscoreForAnother) {
  EXPECT_EQ(text("f(X, _, Y, X, _)"), "f(_0,_1,_2,_0,_3)");
  std::vector<std::string> names;
  for (const Symbol name : scope_.slot_names()) names.emplace_back(symbols_.text(name));
  EXPECT_THAT(names,
              ElementsAre("X", symbols_.text(names::unnamed), "Y", symbols_.text(names::unnamed)));
}

TEST_F(TranslatorTest, TakesNumberedUnderscoresForOneVariableByTheirNumber) {
  EXPECT_EQ(text("f(_1, _2, _1, _1abc, _other, _other)"), "f(_0,_1,_0,_0,_2,_3)");
}

TEST_F(TranslatorTest, FindsTheVariablesThatItHasSeen) {
  const Value x = read("X");
  EXPECT_EQ(scope_.find("X").bits(), x.bits());
  EXPECT_TRUE(scope_.find("Y").is_unset());
}

TEST_F(TranslatorTest, MakesFreshVariablesOfTextsThatAreReadAtRunTime) {
  VariableScope fresh(VariableScope::Kind::variables, heap_, symbols_);
  const Value x = fresh.variable("X");
  EXPECT_TRUE(x.is_variable());
  EXPECT_EQ(fresh.variable("X").bits(), x.bits());
  EXPECT_NE(fresh.variable("_").bits(), fresh.variable("_").bits());
}

TEST_F(TranslatorTest, ReadsSignsOfNumbersAsPartsOfThem) {
  EXPECT_TRUE(read("-3").is_number());
  EXPECT_EQ(text("-3"), "-3");
  EXPECT_EQ(text("+X"), "_0");
  EXPECT_EQ(text("-X"), "(-_0)");
}

TEST_F(TranslatorTest, SortsAnnotationsAsASet) { EXPECT_EQ(text("a[c, b, c, 1]"), "a[1,b,c]"); }

TEST_F(TranslatorTest, KnowsWhichNamesAreFunctions) {
  EXPECT_TRUE(is_form(read("math.abs(X)"), Form::function));
  EXPECT_TRUE(is_form(read("math.abs(X, Y, Z)"), Form::literal)) << "no function of so many";
  EXPECT_TRUE(is_form(read("abs(X)"), Form::literal));
  EXPECT_TRUE(is_form(read("my.twice(X)"), Form::literal));
  translator_.add_function("my.twice", 1);
  EXPECT_TRUE(is_form(read("my.twice(X)"), Form::function));
}

TEST_F(TranslatorTest, PutsTermsIntoTheDefaultNamespaceUnlessTheySayAnother) {
  translator_.set_namespace(symbols_.symbol("n"));
  EXPECT_EQ(text("a(b, m::c, this_ns::d)"), "a(b,m::c,n::d)");
  EXPECT_EQ(text("this_ns"), "n");
}

TEST_F(TranslatorTest, RenamesNamespaces) {
  translator_.rename_namespace(symbols_.symbol("n"), symbols_.symbol("m"));
  EXPECT_EQ(text("n::a(n::b, k::c)"), "m::a(m::b,k::c)");
}

TEST_F(TranslatorTest, KeepsWhatIsAnnotatedOrNegatedOfAVariableForLater) {
  EXPECT_TRUE(read("X").is_slot());
  EXPECT_TRUE(is_form(read("~X"), Form::decorated));
  EXPECT_TRUE(is_form(read("X[a]"), Form::decorated));
  EXPECT_TRUE(is_form(read("n::X"), Form::decorated));
  EXPECT_TRUE(is_form(read("N::a"), Form::decorated));
}

TEST_F(TranslatorTest, FlattensBodiesWithinParentheses) {
  EXPECT_EQ(text("{ a; (b; c); d }"), "{ a; b; c; d }");
}

TEST_F(TranslatorTest, WritesProgramsAsTerms) {
  EXPECT_EQ(text("{ @l +!g(X) : b & not c | X > 1 <- !h; ?i(X); +j; -k; -+l; .m(X) }"),
            "{ @l +!g(_0) : ((b & not (c)) | (_0 > 1)) <- !h; ?i(_0); +j; -k; -+l; .m(_0) }");
  EXPECT_EQ(text("{ a(X) :- b(X) }"), "{ a(_0) :- b(_0) }");
}

TEST(TranslatorOfModules, PutsLiteralsOfPlansAndRulesIntoTheModulesNamespace) {
  const CompiledProgram made(
      "{begin namespace(n)} b(c). a(X) :- b(X) & m::b(X) & X = c. +!g : b(d) <- !h(e); +b(f). "
      "{end}");
  EXPECT_THAT(made.beliefs(),
              ElementsAre("n::b(c)[source(self)]",
                          "{ n::a(_0)[source(self)] :- (n::b(_0) & (m::b(_0) & (_0 = c))) }"));
  const Plan& plan = made.plan();
  EXPECT_EQ(made.text(plan.trigger), "n::g");
  EXPECT_EQ(made.text(plan.code.entry->steps[0].term), "n::h(e)");
  EXPECT_EQ(made.text(plan.code.entry->steps[1].term), "n::b(f)");
}

TEST(TranslatorOfModules, LeavesKeywordsAndActionsInTheDefaultNamespace) {
  const CompiledProgram made(
      "{begin namespace(n)} @l[atomic, mine] +!g[source(percept), x] <- .print(a). {end}");
  const Plan& plan = made.plan();
  EXPECT_TRUE(plan.atomic);
  EXPECT_EQ(made.text(plan.trigger), "n::g[source(percept),x]");
  EXPECT_EQ(made.text(plan.code.entry->steps[0].term), ".print(a)");
}

}  // namespace
}  // namespace jaywalk
