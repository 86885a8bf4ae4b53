// SPDX-License-Identifier: Apache-2.0
#include "env/environment_process/environment_messages.h"

#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "env/process/message_reader.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

using nlohmann::json;

/// `at(X,Y)`: its arguments are names of variables or atoms.
bool is_form(const std::string& text) {
  ast::Arena arena;
  Diagnostics ignored;
  const auto source = std::make_shared<const Source>("form", text);
  const ast::Node* const literal = parse_literal(source, arena, ignored);
  if (literal == nullptr || literal->kind != ast::Kind::literal) return false;
  for (const ast::Node* const arg : literal->args) {
    const bool is_name =
        arg->kind == ast::Kind::variable || (arg->kind == ast::Kind::literal && arg->args.empty());
    if (!is_name) return false;
  }
  return true;
}

std::optional<std::vector<EnvironmentIdentity::Word>> read_words(const json& answer,
                                                                 const char* key,
                                                                 MessageReader& reader) {
  const json* const list = reader.list(answer, key, "its hello", false);
  if (list == nullptr) return std::nullopt;
  const std::string of = fmt::format("the '{}' of its hello", key);
  std::vector<EnvironmentIdentity::Word> words;
  for (const json& each : *list) {
    EnvironmentIdentity::Word word{.form = reader.text(each, "form", of), .meaning = {}};
    if (each.is_object() && each.contains("meaning")) {
      word.meaning = reader.text(each, "meaning", of);
    }
    if (reader.problem().empty() && !is_form(word.form)) {
      reader.reject(fmt::format("'{}' in {} is no form such as at(X,Y)", word.form, of));
    }
    words.push_back(std::move(word));
  }
  return words;
}

/// A whole number is written without a point, as it is in programs.
json argument_json(Value argument, const SymbolTable& symbols) {
  constexpr double kMostWhole = 9007199254740992;  // 2^53
  if (!argument.is_number() || !std::isfinite(argument.as_number())) {
    return source_text(argument, symbols);
  }
  const double number = argument.as_number();
  if (number != std::floor(number) || std::fabs(number) > kMostWhole) return number;
  return static_cast<std::int64_t>(number);
}

std::string name_text(Predicate predicate, const SymbolTable& symbols) {
  const Signature& signature = symbols.signature(predicate);
  std::string text;
  if (signature.ns != names::default_ns) text = fmt::format("{}::", symbols.text(signature.ns));
  if (signature.negated) text += '~';
  text += symbols.text(signature.functor);
  return text;
}

}  // namespace

json environment_hello(std::span<const std::string> arguments) {
  return {{"type", "hello"},
          {"protocol", kEnvironmentProtocol},
          {"name", "jaywalk"},
          {"version", JAYWALK_VERSION},
          {"arguments", arguments}};
}

std::string read_environment_hello(const json& answer, EnvironmentIdentity& identity) {
  constexpr std::string_view kOf = "its hello";
  MessageReader reader;
  const double protocol = reader.number(answer, "protocol", kOf);
  if (reader.problem().empty() && protocol != kEnvironmentProtocol) {
    return fmt::format("it speaks version {:g} of the protocol, this is version {}", protocol,
                       kEnvironmentProtocol);
  }
  identity.name = reader.text(answer, "name", kOf);
  identity.version = reader.text(answer, "version", kOf);
  identity.tick_ms = reader.number_or(answer, "tick_ms", kOf, identity.tick_ms);
  identity.free_running = reader.flag_or(answer, "free_running", kOf, false);
  identity.deterministic = reader.flag_or(answer, "deterministic", kOf, false);
  identity.percepts = read_words(answer, "percepts", reader);
  identity.actions = read_words(answer, "actions", reader);
  if (reader.problem().empty() && !(identity.tick_ms > 0)) {
    return fmt::format("its 'tick_ms' is {:g}, expected more than 0", identity.tick_ms);
  }
  return reader.problem();
}

json action_json(std::string_view agent, const ActionRequest& action, const SymbolTable& symbols) {
  json args = json::array();
  for (const Value argument : action.args) args.push_back(argument_json(argument, symbols));
  return {{"id", action.number},
          {"agent", agent},
          {"action", literal_text(action.predicate, action.args, symbols)},
          {"name", name_text(action.predicate, symbols)},
          {"args", std::move(args)}};
}

std::string literal_text(Predicate predicate, std::span<const Value> args,
                         const SymbolTable& symbols) {
  std::string text = name_text(predicate, symbols);
  for (std::size_t i = 0; i < args.size(); ++i) {
    text += i == 0 ? '(' : ',';
    text += source_text(args[i], symbols);
  }
  if (!args.empty()) text += ')';
  return text;
}

}  // namespace jaywalk
