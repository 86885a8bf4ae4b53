// SPDX-License-Identifier: Apache-2.0
// The formatter changes nothing but blanks, and nothing the second time.

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/syntax/format/formatter.h"
#include "interpreter/syntax/format/formatter_items.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/printer.h"
#include "tests/property/syntax/generator.h"
#include "tests/unit/syntax/outline.h"

namespace jaywalk {
namespace {

constexpr std::uint64_t kProgramSeed = 20260102;
constexpr int kPrograms = 2000;
constexpr int kProgramDepth = 4;

// A program of some components, with blanks, line breaks and comments strewn between its tokens.
class StrewnProgram {
 public:
  explicit StrewnProgram(std::uint64_t seed) : rng_(seed) {
    SyntaxGenerator generator(seed);
    std::string printed;
    for (std::uint64_t i = 0; i <= seed % 3; ++i)
      printed += print(generator.component(kProgramDepth)) + "\n";
    const auto source = std::make_shared<const Source>("printed", printed);
    // Some programs have few comments: their lines stay whole.
    const auto rarity = static_cast<unsigned>(1 + seed % 40);
    Diagnostics ignored;
    for (const format::Item& item : format::items_of(parse_agent(source, ignored))) {
      strew(rarity);
      text += item.text;
      text += ' ';
    }
    strew(rarity);
  }

  std::string text;
  std::vector<std::string> comments;

 private:
  void strew(unsigned rarity) {
    if (rng_() % rarity != 0) return;
    static const std::vector<std::string> kGaps = {
        "\n", "\n\n\n", "\t", "// c", "/* c", " \n// c", "\n/* a\n   c", "/* c", "\n\n// c"};
    const std::string gap = kGaps[rng_() % kGaps.size()];
    text += gap;
    if (gap.find('c') == std::string::npos) return;
    const bool is_line = gap.find("//") != std::string::npos;
    const std::string rest = " " + std::to_string(comments.size()) + (is_line ? "" : " */");
    text += rest;
    comments.push_back(gap.substr(gap.find('/')) + rest);
    if (is_line || rng_() % 2 == 0) text += '\n';
    text += ' ';
  }

  std::mt19937_64 rng_;
};

std::string outline_of(const std::string& text, std::uint64_t seed) {
  Diagnostics diagnostics;
  const ast::File file = parse_agent(std::make_shared<const Source>("text", text), diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << "seed " << seed << "\n" << text << diagnostics.render();
  std::string outlines;
  for (const ast::Component& component : file.components) outlines += outline(component) + "\n";
  return outlines;
}

TEST(Format, KeepsProgramAndComments) {
  for (std::uint64_t seed = kProgramSeed; seed < kProgramSeed + kPrograms; ++seed) {
    const StrewnProgram program(seed);
    const auto once = format_agent(std::make_shared<const Source>("text", program.text));
    ASSERT_TRUE(once) << "seed " << seed << "\n" << program.text << once.diagnostics().render();
    const std::string& text = once.value();
    ASSERT_EQ(outline_of(text, seed), outline_of(program.text, seed)) << "seed " << seed;
    std::size_t at = 0;
    for (const std::string& comment : program.comments) {
      at = text.find(comment, at);
      ASSERT_NE(at, std::string::npos) << "seed " << seed << ": lost " << comment << "\n" << text;
    }
    const auto twice = format_agent(std::make_shared<const Source>("text", text));
    ASSERT_TRUE(twice) << "seed " << seed;
    ASSERT_EQ(twice.value(), text) << "seed " << seed << "\n" << program.text;
  }
}

TEST(Format, LeavesNoBlanksAtTheEndsOfLines) {
  for (std::uint64_t seed = kProgramSeed; seed < kProgramSeed + kPrograms / 10; ++seed) {
    const StrewnProgram program(seed);
    const auto once = format_agent(std::make_shared<const Source>("text", program.text));
    ASSERT_TRUE(once) << "seed " << seed;
    EXPECT_EQ(once.value().find(" \n"), std::string::npos) << "seed " << seed << once.value();
    EXPECT_EQ(once.value().find("\n\n\n"), std::string::npos) << "seed " << seed << once.value();
  }
}

}  // namespace
}  // namespace jaywalk
