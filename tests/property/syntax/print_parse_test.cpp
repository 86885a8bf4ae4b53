// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/printer.h"
#include "tests/property/syntax/generator.h"
#include "tests/unit/syntax/outline.h"

namespace jaywalk {
namespace {

constexpr std::uint64_t kTreeSeed = 20260101;
constexpr int kTrees = 3000;
constexpr int kTreeDepth = 4;

TEST(PrintThenParse, IsIdentityForTerms) {
  for (std::uint64_t seed = kTreeSeed; seed < kTreeSeed + kTrees; ++seed) {
    SyntaxGenerator generator(seed);
    const ast::Node* const tree = generator.term(kTreeDepth);
    const std::string text = print(*tree);
    Diagnostics diagnostics;
    ast::Arena arena;
    const auto source = std::make_shared<const Source>("printed", text);
    const ast::Node* const parsed = parse_term(source, arena, diagnostics);
    ASSERT_NE(parsed, nullptr) << "seed " << seed << "\n" << text << "\n" << diagnostics.render();
    ASSERT_EQ(outline(*parsed), outline(*tree)) << "seed " << seed << "\n" << text;
    ASSERT_EQ(print(*parsed), text) << "seed " << seed;
  }
}

TEST(PrintThenParse, IsIdentityForPrograms) {
  for (std::uint64_t seed = kTreeSeed; seed < kTreeSeed + kTrees; ++seed) {
    SyntaxGenerator generator(seed);
    const ast::Component tree = generator.component(kTreeDepth);
    const std::string text = print(tree);
    Diagnostics diagnostics;
    const ast::File parsed =
        parse_agent(std::make_shared<const Source>("printed", text), diagnostics);
    // Generated contexts may hold what only the checks of the parser refuse.
    ASSERT_FALSE(diagnostics.has_errors()) << "seed " << seed << "\n"
                                           << text << "\n"
                                           << diagnostics.render();
    ASSERT_EQ(parsed.components.size(), 1U) << "seed " << seed << "\n" << text;
    ASSERT_EQ(outline(parsed.components.front()), outline(tree)) << "seed " << seed << "\n" << text;
    ASSERT_EQ(print(parsed.components.front()), text) << "seed " << seed;
  }
}

// Whatever is done to a program's text, the parser comes back, with a diagnostic or without.
TEST(Parser, SurvivesDamagedPrograms) {
  for (std::uint64_t seed = kTreeSeed; seed < kTreeSeed + kTrees; ++seed) {
    SyntaxGenerator generator(seed);
    std::mt19937_64 rng(seed);
    std::string text = print(generator.component(kTreeDepth)) + "\nafter.";
    for (int i = 0; i < 3; ++i) {
      constexpr std::string_view kCharacters = "(){}[].,;:-<>!?+&|@\"'\\/*= \nxX_1~^\xC3";
      text[rng() % text.size()] = kCharacters[rng() % kCharacters.size()];
    }
    Diagnostics diagnostics;
    const ast::File parsed =
        parse_agent(std::make_shared<const Source>("damaged", text), diagnostics);
    if (diagnostics.empty()) {
      EXPECT_FALSE(parsed.components.empty()) << "seed " << seed;
    }
    EXPECT_LT(diagnostics.render().size(), 100'000U) << "seed " << seed;
  }
}

}  // namespace
}  // namespace jaywalk
