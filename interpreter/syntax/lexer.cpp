// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/lexer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/text.h"
#include "interpreter/syntax/token_spellings.h"

namespace jaywalk {
namespace {

using enum TokenKind;

// Printable ASCII that means itself in a string.
constexpr bool is_plain_in_text(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

class Lexer {
 public:
  Lexer(const SourcePtr& source, Diagnostics& diagnostics)
      : source_(source), text_(source->text()), diagnostics_(diagnostics) {
    // A token of a usual program takes about three characters.
    tokens_.reserve(text_.size() / 3 + 1);
  }

  std::vector<Token> run() {
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      const std::size_t begin = at_;
      const TokenKind kind = read_token();
      add({kind, span_from(begin)});
    }
    add({end_of_text, span_from(text_.size())});
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] Span span_from(std::size_t begin) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
  }
  void error(std::size_t begin, std::string message, std::string hint = {}) {
    diagnostics_.error({source_, span_from(begin)}, std::move(message), std::move(hint));
  }

  // Most tokens stand right behind another one.
  [[gnu::always_inline]] void skip_blanks() {
    if (at_ < text_.size() && !may_begin_blank(text_[at_])) return;
    skip_blanks_and_comments();
  }

  static bool may_begin_blank(char c) { return c <= ' ' || c == '/' || c == '#' || c == '%'; }

  [[gnu::noinline]] void skip_blanks_and_comments() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == ' ' || c == '\n' || c == '\t' || c == '\r') continue;
      if (is_foreign_comment()) {
        skip_foreign_comment();
        continue;
      }
      if (c != '/') return;
      // The loop steps over the last character of a comment itself.
      if (peek(1) == '/') {
        at_ = std::min(text_.find_first_of("\n\r", at_), text_.size() - 1);
      } else if (peek(1) == '*') {
        skip_long_comment();
      } else {
        return;
      }
    }
  }

  [[nodiscard]] static bool may_end_operand(TokenKind kind) {
    return kind == variable || kind == number || kind == close || kind == atom;
  }

  // `# text` and `% text`, which other languages have: behind a blank, where no operator could
  // stand.
  [[nodiscard]] bool is_foreign_comment() const {
    if (text_[at_] != '#' && text_[at_] != '%') return false;
    if (at_ > 0 && is_name_character(text_[at_ - 1])) return false;
    // `%` may be a remainder, if an operand stands before it on the line; `#` never means anything.
    if (text_[at_] == '#') return true;
    if (tokens_.empty() || !may_end_operand(tokens_.back().kind)) return true;
    const std::size_t last = tokens_.back().span.end;
    return text_.substr(last, at_ - last).find('\n') != std::string_view::npos;
  }

  // Leaves `at_` at the last character of the line. Of neighbouring lines, the first is reported.
  void skip_foreign_comment() {
    const std::size_t begin = at_;
    const std::uint32_t line = source_->position(static_cast<std::uint32_t>(begin)).line;
    const bool goes_on = foreign_comment_line_ != 0 && foreign_comment_line_ + 1 == line;
    foreign_comment_line_ = line;
    ++at_;
    if (!goes_on) {
      error(begin, fmt::format("unexpected character '{}'", text_[begin]),
            "comments begin with '//'");
    }
    at_ = std::min(text_.find_first_of("\n\r", at_), text_.size()) - 1;
  }

  // Leaves `at_` at the last character of the comment.
  void skip_long_comment() {
    const std::size_t begin = at_;
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) {
      at_ += 2;
      error(begin, "this comment is not closed", "close it with */");
      at_ = text_.size() - 1;
    } else {
      at_ = end + 1;
    }
  }

  TokenKind read_token() {
    const char c = peek();
    if (is_lower(c)) return read_word();
    if (is_upper(c) || c == '_') return read_variable();
    if (is_digit(c)) return read_number();
    if (c == '.' && is_name_character(peek(1))) return read_dotted();
    if (c == '"') return read_string();
    if (c == '\'') return read_quoted_atom();
    for (std::size_t i = kFirstOperator[static_cast<unsigned char>(c)]; i < kOperators.size();
         ++i) {
      const Spelling& spelling = kOperators[i];
      if (spelling.text.front() != c) break;
      if (spelling.text.size() > 1 && !text_.substr(at_).starts_with(spelling.text)) continue;
      if (spelling.text.size() == 2 && (c == '+' || c == '-') && is_behind_operand()) continue;
      at_ += spelling.text.size();
      return spelling.kind;
    }
    return read_garbage();
  }

  // `X--1` is `X - (-1)`; what begins a line is rather a formula, `--b`.
  [[nodiscard]] bool is_behind_operand() const {
    if (tokens_.empty()) return false;
    const auto [kind, where] = tokens_.back();
    const std::string_view between = text_.substr(where.end, at_ - where.end);
    return (kind == variable || kind == number || kind == close) &&
           between.find('\n') == std::string_view::npos;
  }

  // A name whose dots each stand before a name character: `a.b`, `.print`.
  void skip_atom() {
    skip_name();
    while (peek() == '.' && is_name_character(peek(1))) {
      ++at_;
      skip_name();
    }
  }

  void skip_name() {
    const char* next = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    while (next != end && is_name_character(*next)) ++next;
    at_ = static_cast<std::size_t>(next - text_.data());
  }

  TokenKind read_word() {
    const std::size_t begin = at_;
    skip_atom();
    const std::string_view word = text_.substr(begin, at_ - begin);
    // Most atoms are longer than any reserved word, and need not be compared.
    if (word.size() > kLongestWord) return atom;
    for (const Spelling& spelling : kWords) {
      if (spelling.text.front() == word.front() && spelling.text == word) return spelling.kind;
    }
    return atom;
  }

  TokenKind read_variable() {
    skip_name();
    return variable;
  }

  void skip_digits() {
    const char* next = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    while (next != end && is_digit(*next)) ++next;
    at_ = static_cast<std::size_t>(next - text_.data());
  }

  void skip_plain_text() {
    const char* next = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    while (next != end && is_plain_in_text(*next)) ++next;
    at_ = static_cast<std::size_t>(next - text_.data());
  }

  // d+ | d*.d+([eE][+-]?d+)? | d+[eE][+-]?d+
  TokenKind read_number() {
    skip_digits();
    if (peek() == '.' && is_digit(peek(1))) {
      ++at_;
      skip_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
      if (is_digit(peek(1 + sign))) {
        at_ += 1 + sign;
        skip_digits();
      }
    }
    return number;
  }

  // `.5` is a number but `.5x` an atom, since that match is longer.
  TokenKind read_dotted() {
    const std::size_t begin = at_;
    skip_atom();
    const std::size_t atom_end = at_;
    at_ = begin;
    if (is_digit(peek(1))) {
      read_number();
      if (at_ >= atom_end) return number;
    }
    at_ = atom_end;
    return atom;
  }

  TokenKind read_string() {
    const std::size_t begin = at_++;
    for (skip_plain_text(); peek() != '"'; skip_plain_text()) {
      if (at_ >= text_.size() || peek() == '\n' || peek() == '\r') {
        error(begin, "this string is not closed on its line",
              "close it with \" and write line breaks as \\n");
        return bad;
      }
      if (peek() == '\\') {
        check_escape();
        ++at_;
      }
      // A backslash may stand last in the line or text; the next turn reports it.
      if (at_ < text_.size() && peek() != '\n' && peek() != '\r') ++at_;
    }
    ++at_;
    return string;
  }

  void check_escape() {
    // Jason reads more escapes than it translates (builder.cpp); others are mistakes.
    const char escaped = peek(1);
    constexpr std::string_view kKnown = "ntbrf\\'\"01234567";
    if (escaped == '\0' || kKnown.find(escaped) != std::string_view::npos) return;
    if (escaped == '\n' || escaped == '\r') return;
    const std::size_t begin = at_;
    at_ += 2;
    error(begin, "unknown escape in a string",
          "the escapes are \\n \\t \\b \\r \\f \\\\ \\' \\\" and \\ with an octal number");
    at_ = begin;
  }

  TokenKind read_quoted_atom() {
    const std::size_t begin = at_;
    const std::size_t end = text_.find('\'', at_ + 1);
    if (end == std::string_view::npos) {
      ++at_;
      error(begin, "this quoted atom is not closed", "close it with '");
      at_ = std::min(text_.find('\n', begin), text_.size());
      return bad;
    }
    at_ = end + 1;
    return atom;
  }

  // Characters that word processors and web pages substitute for plain ones. A text between such
  // quotes is read as a string or quoted atom, so that the rest is read as it was meant.
  TokenKind read_typographic(const Typographic& written) {
    const std::size_t begin = at_;
    at_ += written.text.size();
    TokenKind kind = bad;
    if (written.meant == "\"" || written.meant == "'") {
      kind = written.meant == "'" ? atom : string;
      skip_to_closing_quote(written.meant);
    }
    error(begin, fmt::format("unexpected '{}'", written.text), std::string(written.hint));
    return kind;
  }

  // Behind the quote of the same kind, typographic or not, that ends it on its line.
  void skip_to_closing_quote(std::string_view meant) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    for (std::size_t i = at_; i < end; ++i) {
      const Typographic* const quote = typographic_at(text_.substr(i));
      const bool is_plain = text_.substr(i).starts_with(meant);
      if (!is_plain && (quote == nullptr || quote->meant != meant)) continue;
      at_ = i + (is_plain ? 1 : quote->text.size());
      return;
    }
  }

  // One diagnostic for a run of characters that begin no token.
  TokenKind read_garbage() {
    if (const Typographic* const written = typographic_at(text_.substr(at_))) {
      return read_typographic(*written);
    }
    const std::size_t begin = at_;
    const auto is_foreign = [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; };
    ++at_;
    while (is_foreign(text_[begin]) && is_foreign(peek()) &&
           typographic_at(text_.substr(at_)) == nullptr) {
      ++at_;
    }
    const std::string_view found = text_.substr(begin, at_ - begin);
    if (found == "\\") {
      if (peek() == '+' || peek() == '=') ++at_;
      const bool after_equals = begin > 0 && text_[begin - 1] == '=';  // =\= of Prolog
      const std::size_t shown = after_equals ? begin - 1 : begin;
      error(shown, fmt::format("unexpected '{}'", text_.substr(shown, at_ - shown)),
            "negation is written 'not', unequal '\\=='");
    } else if (is_foreign(found.front())) {
      error(begin, "unexpected character outside of a string or quoted atom",
            "names consist of the letters a-z and A-Z, digits and _");
    } else if (static_cast<unsigned char>(found.front()) < 0x20U) {
      error(begin, fmt::format("unexpected control character {}", static_cast<int>(found.front())));
    } else {
      error(begin, fmt::format("unexpected character '{}'", found), hint_for(found.front()));
    }
    return bad;
  }

  static std::string hint_for(char found) {
    switch (found) {
      case '%':
        return "the remainder of a division is X mod Y; comments begin with '//'";
      case '$':
        return "variables begin with an upper-case letter";
      case '`':
        return "write a string in \" and a quoted atom in '";
      default:
        return {};
    }
  }

  // Keeps the open brackets, to distinguish a '(' around a body from one around a formula: there
  // is a token in it that only a body can have, directly or within further parentheses.
  void add(Token token) {
    switch (token.kind) {
      case open:
      case open_list:
      case open_brace:
        open_.push_back({tokens_.size(), false});
        break;
      case close:
      case close_list:
      case close_brace:
        close_bracket();
        break;
      case stop:
        // A clause ends here, whatever brackets were left open: the next one begins without.
        open_.clear();
        break;
      case semicolon:
      case fork_and:
      case fork_or:
      case bang:
      case double_bang:
      case question:
      case plus_plus:
      case minus_minus:
      case minus_plus:
      case plus_less:
      case plus_greater:
      case if_word:
      case for_word:
      case while_word:
        if (!open_.empty()) open_.back().is_body = true;
        break;
      default:
        break;
    }
    tokens_.push_back(token);
  }

  void close_bracket() {
    if (open_.empty()) return;
    const Bracket bracket = open_.back();
    open_.pop_back();
    if (!bracket.is_body || tokens_[bracket.token].kind != open) return;
    // The parenthesis around one with a body holds a body, too.
    tokens_[bracket.token].kind = body_open;
    if (!open_.empty()) open_.back().is_body = true;
  }

  struct Bracket {
    std::size_t token;
    bool is_body;
  };

  const SourcePtr& source_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
  std::vector<Bracket> open_;
  std::uint32_t foreign_comment_line_ = 0;  // the last one's, from 1
};

}  // namespace

std::vector<Token> tokenize(const SourcePtr& source, Diagnostics& diagnostics) {
  return Lexer(source, diagnostics).run();
}

}  // namespace jaywalk
