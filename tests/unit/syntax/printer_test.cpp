// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/printer.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/syntax/parser.h"

namespace jaywalk {
namespace {

std::string printed_program(const std::string& text) {
  Diagnostics diagnostics;
  const ast::File file = parse_agent(std::make_shared<const Source>("test", text), diagnostics);
  return diagnostics.empty() ? print(file) : diagnostics.render();
}

std::string printed_term(const std::string& text) {
  Diagnostics diagnostics;
  ast::Arena arena;
  const auto source = std::make_shared<const Source>("test", text);
  const ast::Node* const node = parse_term(source, arena, diagnostics);
  return node != nullptr ? print(*node) : diagnostics.render();
}

struct PrinterRow {
  const char* text;
  const char* printed;
};

TEST(Printer, WritesTermsInJasonsNotation) {
  for (const auto& [text, printed] : {
           PrinterRow{"f( a , [ 1|T ] ) [ x ]", "f(a,[1|T])[x]"},
           PrinterRow{"n::~p", "n::~p"},
           PrinterRow{"X>1&b|not c", "X > 1 & b | not c"},
           PrinterRow{"(X+1)*2 mod 3", "(X+1)*2 mod 3"},
           PrinterRow{"1 - -2", "1- -2"},
           PrinterRow{"\"a\\nb\\\"c\\t\"", "\"a\\nb\\\"c\\t\""},
           PrinterRow{"1.50", "1.5"},
           PrinterRow{"{}", "{ }"},
           PrinterRow{"{!g;?t;+a}", "{ !g; ?t; +a }"},
           PrinterRow{"{@l +!g:c<-b;d}", "{ @l +!g : c <- b; d }"},
           PrinterRow{"{+!g}", "{ +!g }"},
           PrinterRow{"{h:-b}", "{ h :- b }"},
       }) {
    EXPECT_EQ(printed_term(text), printed) << text;
  }
}

TEST(Printer, WritesProgramsAComponentOnEachLine) {
  EXPECT_EQ(printed_program("b(1). h(X):-b(X).!go. @l[atomic]+!go:c<:d<-if(a){b}elif(c){d}else{e};"
                            "for(x){y};while(z){};a|&|(b;c);true.{+!s.}{begin n}c.{end}"),
            "b(1).\n"
            "h(X) :- b(X).\n"
            "!go.\n"
            "@l[atomic] +!go : c <: d <- if (a) { b } elif (c) { d } else { e }; for (x) { y }; "
            "while (z) { }; a |&| (b; c); true. { +!s. }\n"
            "{ begin n }\n"
            "c.\n"
            "{ end }\n");
}

TEST(Printer, KeepsATrueThatTheParserWouldDrop) {
  EXPECT_EQ(printed_program("+!g <- true; true; a."), "+!g <- true; true; a.\n");
}

}  // namespace
}  // namespace jaywalk
