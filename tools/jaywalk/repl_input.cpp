#include "tools/jaywalk/repl_input.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "experiment/trimmed.h"
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

ReplInput clause(const std::string& text) {
  ReplInput input{.kind = ReplInput::Kind::program, .word = {}, .text = text};
  const auto source = std::make_shared<const Source>("input", text);
  Diagnostics found;
  const ast::File file = parse_agent(source, found);
  if (found.has_errors() || file.components.size() != 1) return input;
  const ast::Component& component = file.components.front();
  if (component.kind == ast::ComponentKind::goal) {
    input.kind = ReplInput::Kind::goal;
    input.text = source->text(component.literal->span);
  } else if (component.kind == ast::ComponentKind::plan && is_bare_belief(*component.plan)) {
    const ast::Trigger& trigger = component.plan->trigger;
    const bool adds = trigger.op == ast::TriggerOperator::add;
    input.kind = adds ? ReplInput::Kind::add : ReplInput::Kind::remove;
    input.text = source->text(trigger.literal->span);
  }
  return input;
}

}  // namespace

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

ReplInput read_input(const std::string& text) {
  const std::string_view bare = trimmed(text);
  if (bare.empty()) return {};
  if (bare.front() == ':') {
    const std::size_t blank = std::min(bare.find_first_of(kBlanks), bare.size());
    return {.kind = ReplInput::Kind::command,
            .word = std::string(bare.substr(1, blank - 1)),
            .text = std::string(trimmed(bare.substr(blank)))};
  }
  const std::vector<Token> tokens = tokens_of(bare);
  if (tokens.front().kind == TokenKind::end_of_text) return {};
  if (tokens.front().kind == TokenKind::question) {
    std::size_t begin = tokens.front().span.end;
    if (bare.substr(begin).starts_with('-')) ++begin;
    return {.kind = ReplInput::Kind::query,
            .word = {},
            .text = std::string(without_stop(bare.substr(begin)))};
  }
  return clause(std::string(bare));
}

}  // namespace jaywalk
