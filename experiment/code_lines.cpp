#include "experiment/code_lines.h"

#include <set>
#include <string>

namespace jaywalk {
namespace {

enum class State { code, line_comment, block_comment, string, quoted_atom };

}  // namespace

std::uint64_t code_lines(std::string_view program) {
  std::uint64_t lines = 0;
  bool has_code = false;
  State state = State::code;
  for (std::size_t i = 0; i < program.size(); ++i) {
    const char c = program[i];
    const char next = i + 1 < program.size() ? program[i + 1] : '\n';
    if (c == '\n') {
      lines += has_code ? 1U : 0U;
      has_code = false;
      if (state == State::line_comment) state = State::code;
      continue;
    }
    switch (state) {
      case State::code:
        if (c == '/' && (next == '/' || next == '*')) {
          state = next == '/' ? State::line_comment : State::block_comment;
          ++i;
          break;
        }
        if (c == '"') state = State::string;
        if (c == '\'') state = State::quoted_atom;
        has_code = has_code || (c != ' ' && c != '\t' && c != '\r');
        break;
      case State::line_comment:
        break;
      case State::block_comment:
        if (c == '*' && next == '/') {
          state = State::code;
          ++i;
        }
        break;
      case State::string:
        has_code = true;
        if (c == '\\' && next != '\n') ++i;
        if (c == '"') state = State::code;
        break;
      case State::quoted_atom:
        has_code = true;
        if (c == '\'') state = State::code;
        break;
    }
  }
  return lines + (has_code ? 1U : 0U);
}

std::uint64_t code_lines(const SourceTree& tree) {
  std::uint64_t lines = 0;
  std::set<std::string> seen;
  for (const auto& file : tree.files) {
    if (seen.insert(file->source->name()).second) lines += code_lines(file->source->text());
  }
  return lines;
}

}  // namespace jaywalk
