// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/files/program_text.h"

#include <array>
#include <cstdint>
#include <set>
#include <sha2.h>
#include <string>

#include "interpreter/syntax/lexer.h"

namespace jaywalk {

std::string sha256(std::string_view text) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digits.data());
  return digits.data();
}

std::uint64_t code_lines(const SourcePtr& program) {
  Diagnostics ignored;  // the parser has seen the same text
  std::set<std::uint32_t> lines;
  for (const Token& token : tokenize(program, ignored)) {
    if (token.kind == TokenKind::end_of_text) break;
    const std::uint32_t last = program->position(token.span.end - 1).line;
    for (std::uint32_t line = program->position(token.span.begin).line; line <= last; ++line) {
      lines.insert(line);
    }
  }
  return lines.size();
}

std::uint64_t code_lines(const SourceTree& tree) {
  std::uint64_t lines = 0;
  std::set<std::string> seen;
  for (const auto& file : tree.files) {
    if (seen.insert(file->source->name()).second) lines += code_lines(file->source);
  }
  return lines;
}

}  // namespace jaywalk
