// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/run/world_calls.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/check/index/program_index.h"
#include "interpreter/compile/term_reader.h"
#include "interpreter/compile/translator.h"
#include "interpreter/logic/solutions.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/support/text.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

using nlohmann::json;

/// The arguments of a call as texts; variables without a value have names that no program uses.
json argument_texts(ActionCall& call) {
  std::vector<Value> args;
  for (std::size_t i = 0; i < call.count(); ++i) args.push_back(call.applied(i));
  std::vector<std::pair<Value, Value>> renamed;
  Value rest = call.unifier().rename(call.heap().list(args), &renamed);
  for (std::size_t i = 0; i < renamed.size(); ++i) {
    const Symbol name = call.symbols().symbol(fmt::format("Jaywalk_{}", i));
    renamed[i].second.variable()->name_id = static_cast<std::uint32_t>(name);
  }
  json texts = json::array();
  for (; rest.is_pair(); rest = deref(rest.pair()->tail)) {
    texts.push_back(source_text(deref(rest.pair()->head), call.symbols()));
  }
  return texts;
}

json belief_texts(const Agent& agent) {
  json texts = json::array();
  for (const auto& relation : agent.beliefs().relations()) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Value fact = relation->row(seq).fact;
      if (!fact.is_unset()) texts.push_back(source_text(fact, agent.symbols()));
    }
  }
  return texts;
}

/// "[a,b(X)]": a list as it is written.
std::optional<std::string> list_text(const json& answer) {
  const auto args = answer.find("args");
  if (args == answer.end() || !args->is_array()) return std::nullopt;
  std::string text = "[";
  for (const json& each : *args) {
    if (!each.is_string()) return std::nullopt;
    if (text.size() > 1) text += ',';
    text += each.get_ref<const std::string&>();
  }
  return text + "]";
}

/// Unifies the arguments that have variables with those of an answer. The others may be written
/// differently: a number of an expression.
Outcome unify_arguments(const json& answer, ActionCall& call) {
  const std::optional<std::string> text = list_text(answer);
  const std::optional<Value> read = text ? read_term(*text, call) : std::nullopt;
  if (!read) {
    return call.fail("internal_action",
                     fmt::format("{} answers arguments that are no terms: {}",
                                 call.goal().action->name, shortened(answer.dump(), kMostQuoted)));
  }
  Value rest = deref(*read);
  for (std::size_t i = 0; i < call.count() && rest.is_pair(); ++i) {
    const Value value = deref(rest.pair()->head);
    if (!call.applied(i).is_closed() && !call.unify(i, value)) return Outcome::failed;
    rest = deref(rest.pair()->tail);
  }
  return Outcome::succeeded;
}

std::string text_or(const json& object, const char* key, std::string_view otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>()
                                                     : std::string(otherwise);
}

/// The literal of a text, in the agent's memory; nothing if it is none.
std::optional<Value> literal_of(Agent& agent, std::string_view text, auto parse) {
  ast::Arena arena;
  Diagnostics problems;
  const auto source = std::make_shared<const Source>("the world", std::string(text));
  const ast::Node* const node = parse(source, arena, problems);
  if (node == nullptr || problems.has_errors()) return std::nullopt;
  VariableScope scope(VariableScope::Kind::variables, agent.heap(), agent.symbols());
  Translator translator(agent.heap(), agent.symbols(), agent.machine().actions());
  return agent.machine().unifier().apply(translator.formula(*node, scope));
}

/// A goal of the agent's own, as if a plan had set it.
Value with_own_source(Agent& agent, Value literal) {
  const Value annots = literal_parts(literal).annots;
  if (has_source(annots)) return literal;
  return with_annotations(agent.heap(), literal,
                          union_of(agent.heap(), annots, source_self(), agent.symbols()));
}

void add_functions(const ast::Component& component, std::vector<std::string>& names) {
  for (const ast::Component& inner : component.inner) add_functions(inner, names);
  if (component.kind != ast::ComponentKind::directive) return;
  const ast::Node& directive = *component.literal;
  if (directive.text != "register_function" || directive.args.size() != 1) return;
  names.emplace_back(directive.args[0]->text);
}

}  // namespace

ForeignNames foreign_names(const SourceTree& program) {
  ForeignNames names;
  for (const auto& file : program.files) {
    for (const ast::Component& component : file->components) {
      add_functions(component, names.functions);
    }
  }
  const ProgramWords words = words_of(program);
  for (const Uses& uses : words.uses) {
    for (const ast::Node* const node : uses.internal_actions) {
      const std::string name(node->text);
      const bool is_known = name.starts_with('.') || standard_actions().action(name) != nullptr ||
                            standard_actions().function(name, node->args.size()) != nullptr ||
                            std::ranges::find(names.functions, name) != names.functions.end() ||
                            !words.index.functions.arities(name).empty();
      if (!is_known) names.actions.push_back(name);
    }
  }
  return names;
}

WorldCalls::WorldCalls(ProcessEnvironment& world) : world_(world) {
  actions_.add_all(standard_actions());
}

void WorldCalls::add_missing(const SourceTree& program) {
  const ForeignNames foreign = foreign_names(program);
  for (const std::string& name : foreign.actions) {
    if (actions_.action(name) != nullptr) continue;
    actions_.add(
        own_action(name, 0, -1, [this, name](ActionCall& made) { return call(name, made); }));
  }
  for (const std::string& name : foreign.functions) {
    if (actions_.function(name, 0) != nullptr) continue;
    FunctionDefinition function;
    function.name = name;
    function.most_args = std::numeric_limits<int>::max();
    function.signature = name + "(...)";
    function.own = [this, name](std::span<const Value> args, Heap& /*heap*/, SymbolTable& symbols,
                                Value& result) { return evaluate(name, args, symbols, result); };
    actions_.add(std::move(function));
  }
}

bool WorldCalls::evaluate(const std::string& name, std::span<const Value> args,
                          const SymbolTable& symbols, Value& result) {
  json texts = json::array();
  for (const Value each : args) texts.push_back(source_text(each, symbols));
  json answer;
  if (!world_.call({{"type", "function"}, {"name", name}, {"args", std::move(texts)}}, answer)) {
    return false;
  }
  const auto value = answer.find("result");
  if (value == answer.end() || !value->is_number()) return false;
  result = Value::number(value->get<double>());
  return true;
}

Outcome WorldCalls::call(const std::string& name, ActionCall& call) {
  json question{{"type", "call"},
                {"agent", call.agent()->name()},
                {"name", name},
                {"args", argument_texts(call)}};
  if (needs_beliefs_.contains(name)) question["beliefs"] = belief_texts(*call.agent());
  json answer;
  std::optional<std::size_t> number = world_.call(question, answer);
  if (number && answer.contains("needs") && !question.contains("beliefs")) {
    needs_beliefs_.insert(name);
    question["beliefs"] = belief_texts(*call.agent());
    number = world_.call(question, answer);
  }
  if (!number) return call.fail("internal_action", world_.failure());
  return outcome_of(answer, *number, call);
}

Outcome WorldCalls::outcome_of(const Json& answer, std::size_t number, ActionCall& call) {
  const Json result = answer.value("result", Json());
  if (result == false) return Outcome::failed;
  if (result == "later") return wait(number, call);
  if (result == "error") {
    return call.fail(text_or(answer, "id", "internal_action"), text_or(answer, "message", ""));
  }
  if (!answer.contains("more")) return unify_arguments(answer, call);
  return each(call, [this, answer = Json(answer), number](ActionCall& again) mutable {
    while (answer.value("result", Json()) == true) {
      const Json solution = std::exchange(answer, Json::object());
      const std::size_t trail = again.unifier().mark();
      const bool holds = unify_arguments(solution, again) == Outcome::succeeded;
      if (solution.contains("more") && !world_.call({{"type", "more"}, {"call", number}}, answer)) {
        return false;
      }
      if (holds) return true;
      again.unifier().undo(trail);
    }
    return false;
  });
}

Outcome WorldCalls::wait(std::size_t number, ActionCall& call) {
  if (call.intention() == nullptr) {
    return call.fail("internal_action", "a context or rule cannot wait for its result");
  }
  std::vector<Value> args;
  for (std::size_t i = 0; i < call.count(); ++i) args.push_back(call.applied(i));
  PendingAsk ask;
  ask.id = call.agent()->new_message_id(MessageId::Kind::question);
  ask.answer = call.heap().list(args);
  ask.awaited = 1;
  waiting_[number] = {static_cast<AgentId>(call.agent()->number()), ask.id};
  call.agent()->wait_for_answers(*call.intention(), std::move(ask), -1);
  return Outcome::suspended;
}

void WorldCalls::deliver(Mas& mas) {
  for (const Json& news : world_.take_news()) {
    if (const auto called = news.find("called"); called != news.end()) {
      for (const Json& each : *called) finish(mas, each);
    }
    if (const auto events = news.find("events"); events != news.end()) inform(mas, *events);
  }
}

void WorldCalls::finish(Mas& mas, const Json& called) {
  const auto waiting = waiting_.find(called.value("call", std::size_t(-1)));
  if (waiting == waiting_.end()) return;
  const auto [agent, question] = waiting->second;
  waiting_.erase(waiting);
  std::string problem;
  // An agent that is gone waits no longer.
  (void)mas.intervene(
      agent,
      [&, id = question](Agent& caller) {
        const std::optional<std::string> text = list_text(called);
        const auto args = text ? literal_of(caller, *text, parse_term) : std::nullopt;
        if (args) return caller.answer_question(id, *args);
        ActionError error;
        error.id = "ia_failed";
        error.message = text_or(called, "failed", "its result is no list of terms");
        caller.fail_question(id, error);
      },
      problem);
}

void WorldCalls::inform(Mas& mas, const Json& events) {
  for (std::uint32_t i = 0; i < mas.agent_count(); ++i) {
    const auto agent = static_cast<AgentId>(i);
    const auto own = mas.is_alive(agent) ? events.find(mas.agent_name(agent)) : events.end();
    if (own == events.end()) continue;
    std::string problem;
    (void)mas.intervene(
        agent,
        [&](Agent& told) {
          for (const Json& each : *own) {
            const std::string text = each.get<std::string>();
            const bool is_goal = text.starts_with("+!");
            const auto literal = literal_of(told, text.substr(is_goal ? 2 : 1), parse_literal);
            if (!literal || !is_literal(*literal)) {
              told.log(fmt::format("the world gives '{}', which is no goal or belief",
                                   shortened(text, kMostQuoted)));
            } else if (is_goal) {
              told.add_goal(with_own_source(told, *literal));
            } else if (text.starts_with('+')) {
              told.add_belief(*literal, Place::front, nullptr);
            } else {
              told.remove_belief(*literal, nullptr);
            }
          }
        },
        problem);
  }
}

}  // namespace jaywalk
