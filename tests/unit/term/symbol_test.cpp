// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/symbol.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(SymbolTable, GivesEqualTextsTheSameSymbol) {
  SymbolTable table;
  const Symbol a = table.symbol("alpha");
  EXPECT_EQ(table.symbol(std::string("al") + "pha"), a);
  EXPECT_NE(table.symbol("beta"), a);
  EXPECT_EQ(table.text(a), "alpha");
}

TEST(SymbolTable, HasTheNamesOfTheEngineUnderTheirNumbers) {
  SymbolTable table;
  EXPECT_EQ(table.symbol("default"), names::default_ns);
  EXPECT_EQ(table.text(names::empty), "");
  EXPECT_EQ(table.predicate("source", 1), predicates::source);
  EXPECT_EQ(table.predicate("self", 0), predicates::self);
}

TEST(SymbolTable, TellsPredicatesApartByEachOfTheirParts) {
  SymbolTable table;
  const Predicate plain = table.predicate("p", 1);
  EXPECT_EQ(table.predicate("p", 1), plain);
  EXPECT_NE(table.predicate("p", 2), plain);
  EXPECT_NE(table.predicate("q", 1), plain);
  EXPECT_NE(table.predicate("~p", 1), plain);
  EXPECT_NE(table.predicate({.ns = table.symbol("n"), .functor = table.symbol("p"), .arity = 1}),
            plain);
}

TEST(SymbolTable, ReadsStrongNegationFromTheFunctor) {
  SymbolTable table;
  const Signature& signature = table.signature(table.predicate("~free", 2));
  EXPECT_TRUE(signature.negated);
  EXPECT_EQ(table.text(signature.functor), "free");
  EXPECT_EQ(signature.arity, 2);
}

TEST(SymbolTable, KnowsInternalActionsByTheirDot) {
  SymbolTable table;
  EXPECT_TRUE(table.signature(table.predicate(".print", 1)).dotted);
  EXPECT_TRUE(table.signature(table.predicate("math.max", 2)).dotted);
  EXPECT_FALSE(table.signature(table.predicate("print", 1)).dotted);
  EXPECT_FALSE(table.signature(table.predicate("'a.b'", 0)).dotted);
}

TEST(SymbolTable, FindsTheNamesOfTheTableBelow) {
  const auto base = std::make_shared<SymbolTable>();
  const Symbol known = base->symbol("known");
  const Predicate predicate = base->predicate("known", 3);
  SymbolTable layer(base);
  EXPECT_EQ(layer.symbol("known"), known);
  EXPECT_EQ(layer.predicate("known", 3), predicate);
  EXPECT_EQ(layer.text(known), "known");
}

TEST(SymbolTable, AddsToItsOwnLayerAlone) {
  const auto base = std::make_shared<SymbolTable>();
  const std::size_t symbols = base->symbol_count();
  const std::size_t predicates = base->predicate_count();
  SymbolTable layer(base);
  const Symbol fresh = layer.symbol("fresh");
  const Predicate predicate = layer.predicate("fresh", 0);
  EXPECT_EQ(base->symbol_count(), symbols);
  EXPECT_EQ(base->predicate_count(), predicates);
  EXPECT_EQ(layer.symbol_count(), symbols + 1);
  EXPECT_EQ(layer.text(fresh), "fresh");
  EXPECT_EQ(layer.functor(predicate), "fresh");
}

TEST(SymbolTable, GivesTwoLayersTheSameNumbersForWhatTheyAddInTheSameOrder) {
  const auto base = std::make_shared<SymbolTable>();
  SymbolTable one(base);
  SymbolTable two(base);
  EXPECT_EQ(one.symbol("x"), two.symbol("x"));
  EXPECT_EQ(one.predicate("y", 1), two.predicate("y", 1));
}

TEST(SymbolTable, StacksLayers) {
  const auto base = std::make_shared<SymbolTable>();
  const auto middle = std::make_shared<SymbolTable>(base);
  const Symbol in_middle = middle->symbol("middle");
  SymbolTable top(middle);
  EXPECT_EQ(top.symbol("middle"), in_middle);
  EXPECT_EQ(top.symbol("default"), names::default_ns);
  EXPECT_NE(top.symbol("top"), in_middle);
}

TEST(SymbolTable, KeepsTextsValidWhileItGrows) {
  SymbolTable table;
  const Symbol first = table.symbol("a rather long text that no short string holds");
  const std::string_view text = table.text(first);
  for (int i = 0; i < 10'000; ++i) (void)table.symbol("s" + std::to_string(i));
  EXPECT_EQ(table.text(first).data(), text.data());
  EXPECT_EQ(table.symbol("s77"), table.symbol("s77"));
}

}  // namespace
}  // namespace jaywalk
