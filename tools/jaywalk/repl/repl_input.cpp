// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/repl/repl_input.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <span>
#include <vector>

#include "interpreter/support/text.h"
#include "interpreter/syntax/lexer.h"
#include "interpreter/syntax/parser.h"

namespace jaywalk {
namespace {

std::string_view without_stop(std::string_view text) {
  text = trimmed(text);
  if (text.ends_with('.')) text.remove_suffix(1);
  return trimmed(text);
}

// A block comment that the text ends within: more is to come.
bool ends_in_comment(std::string_view text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      for (++at; at < text.size() && text[at] != c && text[at] != '\n'; ++at) {
        if (text[at] == '\\') ++at;
      }
    } else if (c == '/' && text[at + 1] == '/') {
      at = text.find('\n', at);
      if (at == text.npos) return false;
    } else if (c == '/' && text[at + 1] == '*') {
      at = text.find("*/", at + 2);
      if (at == text.npos) return true;
      ++at;
    }
  }
  return false;
}

std::vector<Token> tokens_of(std::string_view text) {
  Diagnostics ignored;
  return tokenize(std::make_shared<const Source>("input", std::string(text)), ignored);
}

// `+b(1).` without context and body: a belief that is added, not a plan.
bool is_bare_belief(const ast::Plan& plan) {
  return plan.label == nullptr && plan.context == nullptr && plan.goal_condition == nullptr &&
         !plan.has_body && plan.subplans.empty() && plan.trigger.kind == ast::TriggerKind::belief &&
         plan.trigger.op != ast::TriggerOperator::goal_state;
}

// A clause by itself; `text` is all of it, with its stop.
ReplInput clause(const ast::Component& component, const Source& source, std::string text) {
  using Kind = ReplInput::Kind;
  if (component.kind == ast::ComponentKind::goal) {
    return {
        .kind = Kind::goal, .word = {}, .text = std::string(source.text(component.literal->span))};
  }
  if (component.kind == ast::ComponentKind::plan && is_bare_belief(*component.plan)) {
    const ast::Trigger& trigger = component.plan->trigger;
    const bool adds = trigger.op == ast::TriggerOperator::add;
    return {.kind = adds ? Kind::add : Kind::remove,
            .word = {},
            .text = std::string(source.text(trigger.literal->span))};
  }
  return {.kind = Kind::program, .word = {}, .text = std::move(text)};
}

// Adds the clauses between two queries. Consecutive parts of a program stay together.
void add_clauses(std::string_view text, std::vector<ReplInput>& inputs) {
  if (trimmed(text).empty()) return;
  const auto source = std::make_shared<const Source>("input", std::string(text));
  Diagnostics found;
  const ast::File file = parse_agent(source, found);
  if (found.has_errors()) {
    inputs.push_back({.kind = ReplInput::Kind::program, .word = {}, .text = std::string(text)});
    return;
  }
  std::size_t begin = 0;
  for (const ast::Component& component : file.components) {
    const std::size_t end = component.span.end;
    ReplInput input =
        clause(component, *source, std::string(trimmed(text.substr(begin, end - begin))));
    begin = end;
    const bool joins = input.kind == ReplInput::Kind::program && !inputs.empty() &&
                       inputs.back().kind == ReplInput::Kind::program;
    if (joins) {
      inputs.back().text += '\n' + input.text;
    } else {
      inputs.push_back(std::move(input));
    }
  }
}

ReplInput query(std::string_view text) {
  text = trimmed(text);
  text.remove_prefix(1);  // the question mark
  if (text.starts_with('-')) text.remove_prefix(1);
  return {.kind = ReplInput::Kind::query, .word = {}, .text = std::string(without_stop(text))};
}

// Where clauses end: behind a stop outside of braces, or behind the brace of a directive or of
// sub-plans.
class ClauseEnds {
 public:
  /// Whether a clause ends behind this token.
  bool ends(TokenKind kind) {
    if (!is_within_) is_block_ = kind == TokenKind::open_brace;
    is_within_ = true;
    if (kind == TokenKind::open_brace) ++braces_;
    if (kind == TokenKind::close_brace) --braces_;
    const bool is_end =
        braces_ <= 0 && (is_block_ ? kind == TokenKind::close_brace : kind == TokenKind::stop);
    is_within_ = !is_end;
    return is_end;
  }
  [[nodiscard]] bool is_within() const { return is_within_; }

 private:
  int braces_ = 0;
  bool is_within_ = false;
  bool is_block_ = false;  // begins with a brace
};

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

std::string_view last_word(std::string_view text) {
  std::size_t begin = text.size();
  while (begin > 0 && is_of_name(text[begin - 1])) --begin;
  return text.substr(begin);
}

void add_matches(std::span<const std::string> names, std::string_view word,
                 std::vector<std::string>& found) {
  for (const std::string& name : names) {
    if (name.starts_with(word)) found.push_back(name);
  }
}

bool is_within_string(std::string_view text) { return std::ranges::count(text, '"') % 2 == 1; }

}  // namespace

const std::vector<std::string>& repl_commands() {
  static const std::vector<std::string> kCommands = {
      "load", "reload", "beliefs", "rules", "plans", "intentions", "trace", "run", "help", "quit"};
  return kCommands;
}

std::optional<ReplInput> command_alone(std::string_view line) {
  std::string_view word = trimmed(line);
  const bool has_colon = word.starts_with(':');
  if (has_colon) word.remove_prefix(1);
  if (word == "exit") word = "quit";
  const bool is_command = has_colon
                              ? std::ranges::find(repl_commands(), word) != repl_commands().end()
                              : word == "help" || word == "quit";
  if (!is_command) return std::nullopt;
  return ReplInput{.kind = ReplInput::Kind::command, .word = std::string(word), .text = {}};
}

bool is_whole_input(std::string_view text) {
  text = trimmed(text);
  if (text.empty() || text.front() == ':') return true;
  if (ends_in_comment(text)) return false;
  std::vector<TokenKind> open;
  TokenKind last = TokenKind::stop;  // comments alone are whole
  for (const Token& token : tokens_of(text)) {
    switch (token.kind) {
      case TokenKind::end_of_text:
        return open.empty() && (last == TokenKind::stop || last == TokenKind::close_brace);
      case TokenKind::open:
      case TokenKind::body_open:
      case TokenKind::open_list:
      case TokenKind::open_brace:
        open.push_back(token.kind);
        break;
      case TokenKind::close:
      case TokenKind::close_list:
      case TokenKind::close_brace:
        if (open.empty()) return true;
        open.pop_back();
        break;
      case TokenKind::stop:
        // Sub-plans end within braces; nothing does within parentheses and lists.
        if (!open.empty() && open.back() != TokenKind::open_brace) return true;
        break;
      case TokenKind::bad:
        return true;
      default:
        break;
    }
    last = token.kind;
  }
  return true;
}

std::vector<ReplInput> read_inputs(const std::string& text) {
  const std::string_view bare = trimmed(text);
  if (bare.empty()) return {};
  if (bare.front() == ':') {
    const std::size_t blank = std::min(bare.find_first_of(kBlanks), bare.size());
    return {{.kind = ReplInput::Kind::command,
             .word = std::string(bare.substr(1, blank - 1)),
             .text = std::string(trimmed(bare.substr(blank)))}};
  }
  std::vector<ReplInput> inputs;
  ClauseEnds clauses;
  std::size_t begin = 0;
  bool is_query = false;
  for (const Token& token : tokens_of(bare)) {
    if (!clauses.is_within() && token.kind == TokenKind::question) {
      add_clauses(bare.substr(begin, token.span.begin - begin), inputs);
      begin = token.span.begin;
      is_query = true;
    }
    const bool is_last = token.kind == TokenKind::end_of_text;
    if (!is_last && !clauses.ends(token.kind)) continue;
    if (is_query) {
      inputs.push_back(query(bare.substr(begin, token.span.end - begin)));
      begin = token.span.end;
      is_query = false;
    }
    if (is_last) break;
  }
  add_clauses(bare.substr(begin), inputs);
  return inputs;
}

std::string Completion::common() const {
  if (candidates.empty()) return {};
  std::string shared = candidates.front();
  for (const std::string& candidate : candidates) {
    const auto [end, other] = std::ranges::mismatch(shared, candidate);
    shared.erase(end, shared.end());
  }
  return shared;
}

Completion complete_input(std::string_view before, const ReplNames& names) {
  Completion completion;
  const std::string_view word = last_word(before);
  const std::string_view ahead = before.substr(0, before.size() - word.size());
  completion.replaced = word.size();
  if (is_within_string(before)) return completion;
  const std::string_view line = trimmed(before);
  const bool is_command = line.starts_with(':');
  if (is_command && trimmed(ahead) == ":") {
    add_matches(names.commands, word, completion.candidates);
  } else if (ahead.ends_with('!') || line.starts_with(":trace") || line.starts_with(":plans")) {
    add_matches(names.goals, word, completion.candidates);
  } else if (is_command) {
    if (line.starts_with(":beliefs")) add_matches(names.predicates, word, completion.candidates);
  } else if (word.find('.') != word.npos) {
    add_matches(names.actions, word, completion.candidates);
  } else {
    add_matches(names.predicates, word, completion.candidates);
    add_matches(names.goals, word, completion.candidates);
    if (!word.empty()) add_matches(names.actions, word, completion.candidates);
  }
  std::ranges::sort(completion.candidates);
  completion.candidates.erase(
      std::unique(completion.candidates.begin(), completion.candidates.end()),
      completion.candidates.end());
  return completion;
}

}  // namespace jaywalk
