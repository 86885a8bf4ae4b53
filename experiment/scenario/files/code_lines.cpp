#include "experiment/scenario/files/code_lines.h"

#include <set>
#include <string>

#include "interpreter/syntax/lexer.h"

namespace jaywalk {

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
