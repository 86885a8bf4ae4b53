// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/project/project_lexer.h"

#include <algorithm>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

constexpr bool is_slash(char c) { return c == '/' || c == '\\'; }

class ProjectLexer {
 public:
  ProjectLexer(const SourcePtr& source, Diagnostics& diagnostics)
      : source_(source), text_(source->text()), diagnostics_(diagnostics) {}

  std::vector<ProjectToken> run() {
    std::vector<ProjectToken> tokens;
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      begin_ = at_;
      const ProjectTokenKind kind = read();
      tokens.push_back({kind, span(), text_.substr(begin_, at_ - begin_)});
      if (tokens.back().text == "}") break;  // as Jason, which reads no further
    }
    skip_blanks();
    begin_ = at_;
    at_ = text_.size();
    if (begin_ < at_) {
      diagnostics_.warning({source_, {span().begin, span().begin + 1}}, "after-project",
                           "what stands behind the project is left out");
    }
    begin_ = at_;
    tokens.push_back({ProjectTokenKind::end_of_text, span(), {}});
    return tokens;
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] Span span() const {
    return {static_cast<std::uint32_t>(begin_), static_cast<std::uint32_t>(at_)};
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (text_.substr(at_).starts_with("//")) {
        at_ = std::min(text_.find_first_of("\n\r", at_), text_.size());
      } else if (text_.substr(at_).starts_with("/*")) {
        begin_ = at_;
        const std::size_t end = text_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
        if (end == std::string_view::npos) {
          diagnostics_.error({source_, {span().begin, span().begin + 2}},
                             "this comment is not closed", "close it with */");
        }
      } else if (peek() == ' ' || peek() == '\n' || peek() == '\t' || peek() == '\r') {
        ++at_;
      } else {
        return;
      }
    }
  }

  ProjectTokenKind read() {
    const char c = peek();
    if (is_slash(c) || (c == '.' && is_slash(peek(1))) || is_drive()) return read_path();
    if (is_letter(c)) {
      while (is_name_character(peek())) ++at_;
      return ProjectTokenKind::word;
    }
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return read_number();
    if (c == '"') return read_string();
    ++at_;
    if (std::string_view("{}()[]:;,#=.").find(c) != std::string_view::npos)
      return ProjectTokenKind::symbol;
    while (!begins_character(peek())) ++at_;
    diagnostics_.error({source_, span()}, "unexpected character in a project");
    return ProjectTokenKind::bad;
  }

  // d+ | d*.d+([eE][+-]?d+)? | d+[eE][+-]?d+
  ProjectTokenKind read_number() {
    while (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) ++at_;
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      at_ += 1 + sign;
      while (is_digit(peek())) ++at_;
    }
    return ProjectTokenKind::number;
  }

  [[nodiscard]] bool is_drive() const {
    return is_letter(peek()) && peek(1) == ':' && is_slash(peek(2));
  }

  // The folders of a path, up to and with the last slash.
  ProjectTokenKind read_path() {
    std::size_t end = at_ + (is_drive() ? 3 : is_slash(peek()) ? 1 : 2);
    for (std::size_t i = end;
         i < text_.size() && (is_name_character(text_[i]) || is_slash(text_[i])); ++i) {
      if (is_slash(text_[i])) end = i + 1;
    }
    at_ = end;
    return ProjectTokenKind::path;
  }

  ProjectTokenKind read_string() {
    for (++at_; peek() != '"'; ++at_) {
      if (at_ >= text_.size() || peek() == '\n') {
        diagnostics_.error({source_, {span().begin, span().begin + 1}},
                           "this string is not closed on its line");
        return ProjectTokenKind::bad;
      }
      if (peek() == '\\' && peek(1) == '"') ++at_;
    }
    ++at_;
    return ProjectTokenKind::string;
  }

  const SourcePtr& source_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t begin_ = 0;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<ProjectToken> project_tokens(const SourcePtr& source, Diagnostics& diagnostics) {
  return ProjectLexer(source, diagnostics).run();
}

}  // namespace jaywalk
