// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/parser.h"

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/syntax/outline.h"

namespace jaywalk {
namespace {

SourcePtr source_of(std::string text) {
  return std::make_shared<const Source>("test", std::move(text));
}

// The outline of a program, or its diagnostics.
std::string program(const std::string& text) {
  Diagnostics diagnostics;
  const ast::File file = parse_agent(source_of(text), diagnostics);
  return diagnostics.empty() ? outline(file) : diagnostics.render();
}

std::string term(const std::string& text) {
  Diagnostics diagnostics;
  ast::Arena arena;
  const SourcePtr source = source_of(text);
  const ast::Node* const node = parse_term(source, arena, diagnostics);
  return node != nullptr ? outline(*node) : diagnostics.render();
}

std::string plan(const std::string& text) {
  Diagnostics diagnostics;
  ast::Arena arena;
  const SourcePtr source = source_of(text);
  const ast::Plan* const parsed = parse_plan(source, arena, diagnostics);
  return parsed != nullptr ? outline(*parsed) : diagnostics.render();
}

std::string body(const std::string& text) {
  const std::string parsed = plan("+!g <- " + text);
  return parsed.starts_with("+!g <- ") ? parsed.substr(7) : parsed;
}

struct ParserRow {
  const char* text;
  const char* tree;
};

TEST(Parser, BindsOperatorsAsTightlyAsJason) {
  for (const auto& [text, tree] : {
           ParserRow{"1+2*3", "(+ 1 (* 2 3))"},
           ParserRow{"(1+2)*3", "(* (+ 1 2) 3)"},
           ParserRow{"10-3-2", "(- (- 10 3) 2)"},
           ParserRow{"10-(3-2)", "(- 10 (- 3 2))"},
           ParserRow{"2**3**2", "(** 2 (** 3 2))"},
           ParserRow{"-2**2", "(** (neg 2) 2)"},
           ParserRow{"2**-1", "(** 2 (neg 1))"},
           ParserRow{"X- -1", "(- X (neg 1))"},
           ParserRow{"+X*-Y", "(* (pos X) (neg Y))"},
           ParserRow{"7 div 2 mod 3 / 4", "(/ (mod (div 7 2) 3) 4)"},
           ParserRow{"a | b & c | d", "(| a (| (& b c) d))"},
           ParserRow{"a & b & c", "(& a (& b c))"},
           ParserRow{"(a & b) & c", "(& (& a b) c)"},
           ParserRow{"not X > 1 & b", "(& (not (> X 1)) b)"},
           ParserRow{"not (a & b)", "(not (& a b))"},
           ParserRow{"a & not b | c", "(| (& a (not b)) c)"},
           ParserRow{"X+1 < Y*2", "(< (+ X 1) (* Y 2))"},
           ParserRow{"X =.. [ns,f,[1],[]]", "(=.. X [ ns f [ 1 ] [ ] ])"},
           ParserRow{"[a] \\== \"s\"", "(\\== [ a ] \"s\")"},
           ParserRow{"math.max(1,2)+.length(L)", "(+ (math.max 1 2) (.length L))"},
       }) {
    EXPECT_EQ(term(text), tree) << text;
  }
}

TEST(Parser, ReadsLiteralsWithNamespacesNegationArgumentsAndAnnotations) {
  for (const auto& [text, tree] : {
           ParserRow{"p", "p"},
           ParserRow{"~p(X)", "(~p X)"},
           ParserRow{"n::p(1)", "(n::p 1)"},
           ParserRow{"n::~p", "n::~p"},
           ParserRow{"::p", "::p"},
           ParserRow{"N::p", "N::p"},
           ParserRow{"n :: p", "n::p"},
           ParserRow{"p(a & b, not c)[source(self),X|R]",
                     "(p (& a b) (not c))@[ (source self) X | R ]"},
           ParserRow{"P[step(N)|R]", "P@[ (step N) | R ]"},
           ParserRow{"~X", "~X"},
           ParserRow{"'A b'(1)", "('A b' 1)"},
           ParserRow{"begin(end)", "(begin end)"},
           ParserRow{"true", "<true>"},
           ParserRow{"f(false)", "(f <false>)"},
       }) {
    EXPECT_EQ(term(text), tree) << text;
  }
}

TEST(Parser, ReadsLists) {
  for (const auto& [text, tree] : {
           ParserRow{"[]", "[ ]"},
           ParserRow{"[a,B,\"c\",4,[5]]", "[ a B \"c\" 4 [ 5 ] ]"},
           ParserRow{"[H|T]", "[ H | T ]"},
           ParserRow{"[|T]", "[ | T ]"},
           ParserRow{"[a|[b|_]]", "[ a | [ b | _ ] ]"},
           ParserRow{"[X+1,-2,(a & b)]", "[ (+ X 1) (neg 2) (& a b) ]"},
           ParserRow{"[{a;b},{+!g}]", "[ {body a b} {trigger +!g} ]"},
       }) {
    EXPECT_EQ(term(text), tree) << text;
  }
}

TEST(Parser, ReadsNumbers) {
  for (const auto& [text, tree] :
       {ParserRow{"42", "42"}, ParserRow{".5", "0.5"}, ParserRow{"1.25e3", "1250"},
        ParserRow{"1E-2", "0.01"}, ParserRow{"9007199254740993", "9007199254740992"},
        ParserRow{"1e999", "inf"}, ParserRow{"1e-999", "0"}}) {
    EXPECT_EQ(term(text), tree) << text;
  }
}

TEST(Parser, ConvertsOnlyLineBreaksAndQuotesInStrings) {
  EXPECT_EQ(term(R"("a\nb")"), "\"a\nb\"");
  EXPECT_EQ(term(R"("say \"x\"")"), "\"say \"x\"\"");
  EXPECT_EQ(term(R"("a\tb\\")"), "\"a\\tb\\\\\"");
  EXPECT_EQ(term(R"("\\n")"), "\"\\\n\"");
}

TEST(Parser, TellsTheTermsInBracesApart) {
  for (const auto& [text, tree] : {
           ParserRow{"{ }", "{body}"},
           ParserRow{"{ a }", "{body a}"},
           ParserRow{"{+b}", "{body +b}"},
           ParserRow{"{-b; c}", "{body -b c}"},
           ParserRow{"{+b |&| c}", "{body and:(.fork and {body +b} {body c})}"},
           ParserRow{"{++b}", "{body ++b}"},
           ParserRow{"{+X}", "{body +X}"},
           ParserRow{"{+!g}", "{trigger +!g}"},
           ParserRow{"{-?t(X)}", "{trigger -?(t X)}"},
           ParserRow{"{^!g[state(S)]}", "{trigger ^!g@[ (state S) ]}"},
           ParserRow{"{+!g <- a; b}", "{plan +!g <- a b}"},
           ParserRow{"{+!g : c}", "{plan +!g : c}"},
           ParserRow{"{+!g <- }", "{plan +!g <-}"},
           ParserRow{"{+b : c <- d}", "{plan +b : c <- d}"},
           ParserRow{"{-b <- d}", "{plan -b <- d}"},
           ParserRow{"{@l[x] +b}", "{plan @l@[ x ] +b}"},
           ParserRow{"{@L +!g}", "{plan @L +!g}"},
           ParserRow{"{@[atomic] +!g <- a}", "{plan @[ atomic ] +!g <- a}"},
           ParserRow{"{h(X) :- b & c}", "{rule (h X) (& b c)}"},
           ParserRow{"{!g; ?t; .print(1)}", "{body !g ?t (.print 1)}"},
       }) {
    EXPECT_EQ(term(text), tree) << text;
  }
}

TEST(Parser, ReadsTheFormulasOfBodies) {
  for (const auto& [text, tree] : {
           ParserRow{"!a; !!b; ?c; +d; ++e; +<f; +>g; -h; --i; -+j",
                     "!a !!b ?c +d ++e +<f +>g -h --i -+j"},
           ParserRow{"act(1); .print(a); X = 1; X; a.b", "(act 1) (.print a) (= X 1) X a.b"},
           ParserRow{"?a & b(X)", "?(& a (b X))"},
           ParserRow{"?(a | b); (X + 1) > 2", "?(| a b) (> (+ X 1) 2)"},
           ParserRow{"not x; a & b", "(not x) (& a b)"},
           ParserRow{"!X; !ns::g(1)[a]; -~b", "!X !(ns::g 1)@[ a ] -~b"},
           ParserRow{"+{+!g <- a}; -{+!g}; +{h :- b}",
                     "+{plan +!g <- a} -{trigger +!g} +{rule h b}"},
           ParserRow{"a;", "a"},
           ParserRow{"(a; b); c", "{body a b} c"},
       }) {
    EXPECT_EQ(body(text), tree) << text;
  }
}

TEST(Parser, MakesInternalActionsOfStatements) {
  for (const auto& [text, tree] : {
           ParserRow{"if (a) { b }", "if:(.if_then_else a {body b})"},
           ParserRow{"if (a & X > 1) { b; c } else { }",
                     "if:(.if_then_else (& a (> X 1)) {body b c} {body})"},
           ParserRow{"if (a) {b} elif (c) {d} else {e}",
                     "if:(.if_then_else a {body b} {body if:(.if_then_else c {body d} {body e})})"},
           ParserRow{"for (.member(X,L)) { !a; }; b", "for:(.foreach (.member X L) {body !a}) b"},
           ParserRow{"while (not a) { b } c", "while:(.loop (not a) {body b}) c"},
           ParserRow{"a |&| b |&| c", "and:(.fork and {body a} {body b} {body c})"},
           ParserRow{"!a ||| !b", "or:(.fork or {body !a} {body !b})"},
           ParserRow{"a |&| b ||| c",
                     "or:(.fork or {body and:(.fork and {body a} {body b})} {body c})"},
           ParserRow{"a |&| (b ||| c)",
                     "and:(.fork and {body a} {body or:(.fork or {body b} {body c})})"},
           ParserRow{"(a; b) |&| (c)", "and:(.fork and {body a b} {body c})"},
       }) {
    EXPECT_EQ(body(text), tree) << text;
  }
}

TEST(Parser, DropsALeadingTrueOfAPlan) {
  EXPECT_EQ(plan("+!g <- true"), "+!g <-");
  EXPECT_EQ(plan("+!g <- true; true; a"), "+!g <- <true> a");
  EXPECT_EQ(plan("+!g <- a; true"), "+!g <- a <true>");
  EXPECT_EQ(term("{+!g <- true; a}"), "{plan +!g <- a}");
}

TEST(Parser, ReadsPlans) {
  for (const auto& [text, tree] : {
           ParserRow{"+b", "+b"},
           ParserRow{"-!g(X)[a] : c <- d.", "-!(g X)@[ a ] : c <- d"},
           ParserRow{"@l[atomic,cost(1)] +?t <- a", "@l@[ atomic (cost 1) ] +?t <- a"},
           ParserRow{"@[atomic] ^!g", "@[ atomic ] ^!g"},
           ParserRow{"@begin +!X", "@begin +!X"},
           ParserRow{"+!g <: false <- a", "+!g <: <false> <- a"},
           ParserRow{"+!g : c <: d & e <- .", "+!g : c <: (& d e) <-"},
           ParserRow{"+!g <- a. { @s +!h. +b <- c. }", "+!g <- a { @s +!h +b <- c }"},
           ParserRow{"+!g <- a. { +!h <- b. { +!i. } }", "+!g <- a { +!h <- b { +!i } }"},
       }) {
    EXPECT_EQ(plan(text), tree) << text;
  }
}

TEST(Parser, ReadsPrograms) {
  EXPECT_EQ(program("b(1). h(X) :- b(X) & X > 0.\n"
                    "!go.\n"
                    "{ include(\"x.asl\", n) }\n"
                    "+!go <- a. { +!sub. }\n"
                    "{ begin namespace(n,local) } c. { begin x } !d. { end } { end }\n"
                    "+b : c."),
            "belief (b 1)\n"
            "belief (h X) :- (& (b X) (> X 0))\n"
            "goal go\n"
            "directive (include \"x.asl\" n)\n"
            "plan +!go <- a { +!sub }\n"
            "block (namespace n local) { belief c block x { goal d } }\n"
            "plan +b : c\n");
}

TEST(Parser, AcceptsEmptyPrograms) {
  EXPECT_EQ(program(""), "");
  EXPECT_EQ(program("// nothing\n/* at all */"), "");
}

TEST(Parser, TellsADirectiveBehindAPlanFromItsSubPlans) {
  EXPECT_EQ(program("+!g <- a. { include(\"x\") }"),
            "plan +!g <- a\n"
            "directive (include \"x\")\n");
}

TEST(Parser, PointsAtTheTextOfEachNode) {
  Diagnostics diagnostics;
  const SourcePtr source = source_of("  +!g(X) : n::~b[a] & X+1 > 2 <- .print( X ); -c.");
  const ast::File file = parse_agent(source, diagnostics);
  const ast::Plan& plan = *file.components.front().plan;
  EXPECT_EQ(source->text(plan.span), source->text().substr(2));
  EXPECT_EQ(source->text(plan.trigger.span), "+!g(X)");
  EXPECT_EQ(source->text(plan.context->span), "n::~b[a] & X+1 > 2");
  EXPECT_EQ(source->text(plan.context->args[0]->span), "n::~b[a]");
  EXPECT_EQ(source->text(plan.body[0].span), ".print( X )");
  EXPECT_EQ(source->text(plan.body[1].span), "-c");
}

TEST(Parser, RemembersParentheses) {
  Diagnostics diagnostics;
  ast::Arena arena;
  const SourcePtr source = source_of("(X + 1) * Y");
  const ast::Node* const node = parse_term(source, arena, diagnostics);
  ASSERT_NE(node, nullptr);
  EXPECT_TRUE(node->args[0]->parenthesised);
  EXPECT_FALSE(node->args[1]->parenthesised);
  EXPECT_FALSE(node->parenthesised);
}

TEST(Parser, ReadsAnyTermsGivenAsText) {
  EXPECT_EQ(term("a & b | X > 1"), "(| (& a b) (> X 1))");
  Diagnostics diagnostics;
  ast::Arena arena;
  EXPECT_EQ(parse_term(source_of("a b"), arena, diagnostics), nullptr);
  EXPECT_EQ(parse_term(source_of(""), arena, diagnostics), nullptr);
  EXPECT_EQ(parse_literal(source_of("1"), arena, diagnostics), nullptr);
  EXPECT_EQ(parse_plan(source_of("+!g <- a. b."), arena, diagnostics), nullptr);
  EXPECT_EQ(diagnostics.error_count(), 4U);
}

TEST(Parser, ReadsLiteralsGivenAsText) {
  Diagnostics diagnostics;
  ast::Arena arena;
  const SourcePtr several = source_of("a(1), ~b[x],c");
  const SourcePtr none = source_of(" ");
  EXPECT_EQ(outline(*parse_literals(several, arena, diagnostics)), "[ (a 1) ~b@[ x ] c ]");
  EXPECT_EQ(outline(*parse_literals(none, arena, diagnostics)), "[ ]");
  EXPECT_TRUE(diagnostics.empty());
}

}  // namespace
}  // namespace jaywalk
