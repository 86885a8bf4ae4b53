// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/syntax_error.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

using enum TokenKind;

constexpr std::size_t kLongestQuoted = 40;

bool is_opening(TokenKind kind) {
  return kind == open || kind == body_open || kind == open_list || kind == open_brace;
}

bool is_closing(TokenKind kind) {
  return kind == close || kind == close_list || kind == close_brace;
}

bool is_word(TokenKind kind) { return kind >= true_word && kind <= while_word; }

TokenKind closing_of(TokenKind opening) {
  return opening == open_list ? close_list : opening == open_brace ? close_brace : close;
}

// In which part of a clause, and in which brackets, a token stands.
struct Place {
  enum class Part { head, context, body, rule };
  Part part = Part::head;
  std::vector<const Token*> brackets;
};

Place place_of(const Token* clause, const Token* token) {
  Place place;
  for (const Token* at = clause; at != token; ++at) {
    if (is_opening(at->kind)) {
      place.brackets.push_back(at);
    } else if (is_closing(at->kind) && !place.brackets.empty()) {
      place.brackets.pop_back();
    } else if (place.brackets.empty()) {
      if (at->kind == colon) place.part = Place::Part::context;
      if (at->kind == arrow) place.part = Place::Part::body;
      if (at->kind == rule) place.part = Place::Part::rule;
    }
  }
  return place;
}

// Spellings from other languages, and their meaning here.
struct Misspelling {
  std::string_view written;
  std::string_view hint;
};

constexpr std::array kMisspellings = {
    Misspelling{"=\\=", "unequal is written '\\=='"},
    Misspelling{"=:=", "equal is written '=='"},
    Misspelling{"<--", "the body of a plan begins with '<-'"},
    Misspelling{"-->", "the body of a plan begins with '<-'"},
    Misspelling{":=", ""},  // it depends on the place
    Misspelling{"->", "the body of a plan begins with '<-'"},
    Misspelling{"=>", "the body of a plan begins with '<-', greater or equal is '>='"},
    Misspelling{"!=", "unequal is written '\\=='"},
    Misspelling{"=<", "less or equal is written '<='"},
    Misspelling{"&&", "conjunctions are written with a single '&'"},
    Misspelling{"||", "disjunctions are written with a single '|'"},
    Misspelling{"is", "arithmetic needs no 'is': write X = Y + 1"},
    Misspelling{"and", "conjunctions are written with '&'"},
    Misspelling{"or", "disjunctions are written with '|'"},
};

struct Finding {
  Span span;
  std::string_view hint;
};

// A misspelt operator that covers the place where the parser stopped.
std::optional<Finding> misspelling_at(std::string_view text, std::uint32_t offset) {
  for (const auto& [written, hint] : kMisspellings) {
    // The parser may have stopped at any of the operator's characters.
    for (std::uint32_t back = 0; back < written.size() && back <= offset; ++back) {
      const std::uint32_t begin = offset - back;
      if (!text.substr(begin).starts_with(written)) continue;
      const auto end = begin + static_cast<std::uint32_t>(written.size());
      const bool is_name = is_name_character(written.front());
      // A word must be whole: `is` within `island` is none.
      if (is_name && (back > 0 || (end < text.size() && is_name_character(text[end])))) continue;
      return Finding{{begin, end}, hint};
    }
  }
  return std::nullopt;
}

class Reporter {
 public:
  Reporter(const SyntaxError& error, Diagnostics& diagnostics)
      : error_(error),
        diagnostics_(diagnostics),
        text_(error.source->text()),
        place_(place_of(error.clause, error.found)) {}

  const Token* run() {
    // The lexer has reported it.
    if (error_.found->kind == bad) return next_clause(error_.tokens, error_.clause, error_.found);
    if (const Token* next = clause_that_follows()) {
      const Span last = next[-1].span;
      add({last.end, last.end}, "expected '.' at the end of this clause",
          fmt::format("the next clause seems to begin on line {}", line_of(*next)));
      return next;
    }
    describe();
    return next_clause(error_.tokens, error_.clause, error_.found);
  }

 private:
  void add(Span span, std::string message, std::string hint = {}) {
    diagnostics_.error({error_.source, span}, std::move(message), std::move(hint));
  }

  [[nodiscard]] std::uint32_t line_of(const Token& token) const {
    return error_.source->position(token.span.begin).line;
  }

  [[nodiscard]] std::string_view text_of(const Token& token) const {
    return error_.source->text(token.span);
  }

  [[nodiscard]] bool begins_line(const Token* token) const {
    const std::string_view between =
        text_.substr(token[-1].span.end, token->span.begin - token[-1].span.end);
    return between.find('\n') != std::string_view::npos;
  }

  // The full stop before a clause that begins a line is easily forgotten: then the parser fails at
  // one of the first tokens of that line, `+ !g`, `@ label`, or a name after a complete formula.
  [[nodiscard]] const Token* clause_that_follows() const {
    const Token* first = error_.found;
    // Back to the first token of the line, at most three tokens.
    for (int i = 0; i < 3 && first > error_.clause && !begins_line(first); ++i) --first;
    if (first <= error_.clause || !begins_line(first)) return nullptr;
    if (!place_of(error_.clause, first).brackets.empty()) return nullptr;
    if (!may_end_clause(first[-1].kind)) return nullptr;
    switch (first->kind) {
      case at:
        return first;
      case plus:
      case minus:
      case caret:
        // Otherwise the line may go on with a sum.
        return first[1].kind == bang || first[1].kind == question || error_.found == first ||
                       error_.found->kind == colon || error_.found->kind == arrow
                   ? first
                   : nullptr;
      case bang:
      case tilde:
      case open_brace:
        return error_.found == first ? first : nullptr;
      case atom:
        return error_.found == first && !is_connective(text_of(*first)) ? first : nullptr;
      default:
        return nullptr;
    }
  }

  [[nodiscard]] static bool may_end_clause(TokenKind kind) {
    return kind == atom || kind == variable || kind == number || kind == string || kind == close ||
           kind == close_list || kind == close_brace || kind == true_word || kind == false_word ||
           kind == semicolon;
  }

  [[nodiscard]] static bool is_connective(std::string_view word) {
    return word == "is" || word == "and" || word == "or";
  }

  [[nodiscard]] std::string found() const {
    const Token& token = *error_.found;
    if (token.kind == atom || token.kind == variable || token.kind == number) {
      return fmt::format("'{}'", shortened(text_of(token), kLongestQuoted));
    }
    if (token.kind == string) return shortened(text_of(token), kLongestQuoted);
    return std::string(name_of(token.kind));
  }

  // The grammar asks for the one token that must come; here is what else could.
  [[nodiscard]] std::string expected() const {
    using Part = Place::Part;
    const std::string& expected = error_.expected;
    const bool after_semicolon = error_.found > error_.clause && error_.found[-1].kind == semicolon;
    if (expected == "'.'" && place_.brackets.empty()) {
      const TokenKind first = error_.clause->kind;
      const bool plan = first == at || first == plus || first == minus || first == caret;
      if (place_.part == Part::body) return after_semicolon ? "a formula or '.'" : "';' or '.'";
      if (place_.part == Part::context) return "'&', '|', '<-' or '.'";
      if (place_.part == Part::rule) return "'&', '|' or '.'";
      if (error_.clause->kind == bang || error_.clause->kind == open_brace) return expected;
      return plan ? "':', '<-' or '.'" : "':-' or '.'";
    }
    if (place_.brackets.empty()) return expected;
    const TokenKind bracket = place_.brackets.back()->kind;
    if (expected == "')'" && is_call(*place_.brackets.back())) return "',' or ')'";
    if (expected == "']'" && bracket == open_list) return "',', '|' or ']'";
    if (expected == "'}'" && error_.found->kind == semicolon && !after_semicolon) {
      return "'<-' or '}'";
    }
    if (expected == "'}'") return after_semicolon ? "a formula or '}'" : "';' or '}'";
    return expected;
  }

  // `p(`, not `( X + 1`.
  [[nodiscard]] bool is_call(const Token& bracket) const {
    return &bracket > error_.tokens.data() && (&bracket)[-1].kind == atom &&
           (&bracket)[-1].span.end == bracket.span.begin;
  }

  void describe() {
    Span span = error_.found->span;
    std::string what = found();
    std::string hint;
    if (const auto misspelt = misspelling_at(text_, span.begin)) {
      span = misspelt->span;
      what = fmt::format("'{}'", error_.source->text(span));
      hint = misspelt->hint.empty() ? hint_for_assignment(span.begin) : misspelt->hint;
      // It begins in a token that the grammar accepted, so the expected token does not help.
      if (span.begin < error_.found->span.begin) {
        add(span, fmt::format("unexpected {}", what), std::move(hint));
        return;
      }
    } else {
      hint = hint_for(*error_.found);
    }
    if (error_.found->kind == end_of_text && place_.brackets.empty()) {
      // The end of the text is on an empty line, mostly.
      const Token* const last = error_.found > error_.clause ? error_.found - 1 : error_.found;
      span = {last->span.end, last->span.end};
    }
    if (error_.found->kind == end_of_text) span.end = span.begin;
    add(span, fmt::format("expected {}, found {}", expected(), what), std::move(hint));
  }

  [[nodiscard]] std::string hint_for(const Token& token) const {
    if (std::string hint = hint_for_block(); !hint.empty()) return hint;
    if (std::string hint = hint_for_clause(token); !hint.empty()) return hint;
    if (token.kind == comma && error_.expected.starts_with('\'')) return hint_for_comma();
    if (is_closing(token.kind) && place_.brackets.empty()) {
      return fmt::format("there is no bracket that this {} could close", name_of(token.kind));
    }
    if (token.kind == atom && token.span.end > token.span.begin && text_[token.span.begin] == '.' &&
        error_.expected == "'.'") {
      return "put a blank or line break after the full stop";
    }
    if (token.kind == close && &token > error_.clause && (&token)[-1].kind == open &&
        error_.expected == "a term") {
      return "without arguments, there are no parentheses";
    }
    if (is_word(token.kind) && token.kind != begin_word && token.kind != end_word &&
        token.kind != not_word && token.kind != else_word && token.kind != elif_word) {
      return fmt::format("{} is a reserved word", name_of(token.kind));
    }
    if (token.kind == not_word) return "put the negation in parentheses";
    if (token.kind == open_brace && error_.expected == "a literal") {
      return "a term in braces cannot be a goal";
    }
    if (token.kind == else_word || token.kind == elif_word) {
      return fmt::format("{} follows the '}}' of an 'if', without a ';'", name_of(token.kind));
    }
    if ((token.kind == open || token.kind == body_open) && &token > error_.clause &&
        (&token)[-1].kind == variable) {
      return "a variable cannot have arguments; names begin with a lower-case letter";
    }
    if (token.kind == bang && place_.part == Place::Part::context && place_.brackets.empty()) {
      return "goals belong in the body of a plan, not in its context";
    }
    return place_.brackets.empty() ? std::string() : hint_for_bracket(token);
  }

  // For a token outside all brackets with which a clause cannot go on.
  [[nodiscard]] std::string hint_for_clause(const Token& token) const {
    if (!place_.brackets.empty() || error_.expected != "'.'") return {};
    if (token.kind == end_of_text) return "each clause ends with '.'";
    const bool is_condition =
        place_.part == Place::Part::context || place_.part == Place::Part::rule;
    const bool begins_formula = token.kind == atom || token.kind == variable || token.kind == open;
    if (is_condition && begins_formula && text_[token.span.begin] != '.') {
      return "conjunctions are written with '&'";
    }
    const TokenKind first = error_.clause->kind;
    if (first == bang && token.kind == rule) return "the head of a rule is a belief, without '!'";
    if (place_.part != Place::Part::head || (first != atom && first != tilde)) return {};
    if (token.kind == arrow) return "a plan begins with '+' or '-'; a rule is written with ':-'";
    if (token.kind == colon) {
      return has_arrow() ? "a plan begins with '+' or '-'" : "a rule is written with ':-'";
    }
    return token.kind == minus ? hint_for_hyphen(token) : std::string();
  }

  // Whether the clause goes on with the body of a plan.
  [[nodiscard]] bool has_arrow() const {
    const Token* at = error_.found;
    while (at->kind != stop && at->kind != end_of_text && at->kind != arrow) ++at;
    return at->kind == arrow;
  }

  // `time-to-cross` for `time_to_cross`.
  [[nodiscard]] std::string hint_for_hyphen(const Token& token) const {
    const Token* at = &token;
    std::string name(text_of(at[-1]));
    for (; at->kind == minus && at[-1].kind == atom && at[1].kind == atom; at += 2) {
      if (at->span.begin != at[-1].span.end || at[1].span.begin != at->span.end) return {};
      name += fmt::format("_{}", text_of(at[1]));
    }
    return at == &token ? std::string() : fmt::format("names have no '-': write '{}'", name);
  }

  // A hint on the meaning of `:=` at an offset of the clause.
  [[nodiscard]] std::string hint_for_assignment(std::uint32_t offset) const {
    const Token* token = error_.clause;
    while (token->span.begin < offset && token != error_.found) ++token;
    const Place place = place_of(error_.clause, token);
    if (place.part != Place::Part::head || !place.brackets.empty()) {
      return "a variable gets its value by '=', as in X = Y + 1, and keeps it";
    }
    const TokenKind first = error_.clause->kind;
    return first == atom || first == tilde ? "a rule is written with ':-'"
                                           : "the body of a plan begins with '<-'";
  }

  // The body of `if (C)` or `else` needs braces.
  [[nodiscard]] std::string hint_for_block() const {
    if (error_.found == error_.clause) return {};
    const TokenKind before = error_.found[-1].kind;
    const bool is_else_if = before == else_word && error_.found->kind == if_word;
    if (is_else_if) return "'else if' is written 'elif'";
    if (error_.expected == "'{'" && (before == close || before == else_word)) {
      return "what 'if', 'else', 'for' and 'while' do stands in braces, as in if (C) { a; b }";
    }
    const bool begins =
        before == if_word || before == elif_word || before == for_word || before == while_word;
    return error_.expected == "'('" && begins
               ? "the condition stands in parentheses, as in if (X > 1) { a }"
               : "";
  }

  [[nodiscard]] std::string hint_for_comma() const {
    if (place_.brackets.empty()) {
      return place_.part == Place::Part::body   ? "the formulas of a body are separated by ';'"
             : place_.part == Place::Part::head ? ""
                                                : "conjunctions are written with '&'";
    }
    const Token& bracket = *place_.brackets.back();
    if (bracket.kind == open_brace) return "the formulas of a body are separated by ';'";
    return "conjunctions are written with '&'";
  }

  [[nodiscard]] std::string hint_for_bracket(const Token& token) const {
    const Token& bracket = *place_.brackets.back();
    const bool logical = token.kind == ampersand || token.kind == not_word ||
                         (token.kind >= less && token.kind <= univ);
    if (bracket.kind == open_list && logical) {
      return "a logical formula in a list needs parentheses";
    }
    const bool ends = token.kind == stop || token.kind == bang || token.kind == at ||
                      token.kind == end_of_text || token.kind == arrow || token.kind == rule ||
                      (is_closing(token.kind) && token.kind != closing_of(bracket.kind));
    if (!ends) return {};
    const auto [line, column] = error_.source->position(bracket.span.begin);
    return fmt::format("the {} at line {}, column {} is not closed", name_of(bracket.kind), line,
                       column);
  }

  const SyntaxError& error_;
  Diagnostics& diagnostics_;
  std::string_view text_;
  Place place_;
};

}  // namespace

const Token* next_clause(std::span<const Token> tokens, const Token* clause, const Token* from) {
  const Token* const end = &tokens.back();
  for (const Token* at = from; at < end; ++at) {
    if (at->kind == stop) return at + 1;
    const bool ends_block =
        at->kind == open_brace &&
        (at[1].kind == begin_word || (at[1].kind == end_word && at[2].kind == close_brace));
    if (ends_block && at > clause) return at;
  }
  return end;
}

const Token* report(const SyntaxError& error, Diagnostics& diagnostics) {
  return Reporter(error, diagnostics).run();
}

}  // namespace jaywalk
