// SPDX-License-Identifier: Apache-2.0
// Messages.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

struct Alias {
  std::string_view written;
  std::string_view meant;
};
constexpr std::array<Alias, 5> kAliases{{{"ask-one", "askOne"},
                                         {"ask-all", "askAll"},
                                         {"ask-how", "askHow"},
                                         {"tell-how", "tellHow"},
                                         {"untell-how", "untellHow"}}};

/// An atom of the default namespace without strong negation: its text is its functor.
bool is_plain_atom(Value value) {
  return value.is_atom() && !is_foreign(value.atom_id()) && !is_negated(value.atom_id());
}

/// The text of a string, or the name that an atom of the default namespace is; `buffer` holds what
/// others are printed as.
std::string_view name_of(Value value, const SymbolTable& symbols, std::string& buffer) {
  if (value.is_text()) return value.text()->view();
  if (is_plain_atom(value)) return symbols.functor(value.atom_id());
  buffer = text_of(value, symbols);
  return buffer;
}

bool is_usual(Symbol performative) {
  return performative >= names::tell_text && performative <= names::ask_how_text;
}

/// The performative that an argument names; the empty name if it does not name one.
Symbol performative_of(Value value, SymbolTable& symbols) {
  if (!is_unsigned_atom(value)) return names::empty;
  if (is_plain_atom(value)) {
    const Symbol functor = symbols.signature(value.atom_id()).functor;
    if (is_usual(functor)) return functor;
  }
  std::string buffer;
  std::string_view name = name_of(value, symbols, buffer);
  if (name.size() > 2 && name.front() == '\'' && name.back() == '\'') {
    name = name.substr(1, name.size() - 2);
  }
  const auto* const alias = std::find_if(kAliases.begin(), kAliases.end(),
                                         [&](const Alias& each) { return each.written == name; });
  return symbols.symbol(alias == kAliases.end() ? name : alias->meant);
}

bool asks(Symbol performative) {
  return performative == names::ask_one_text || performative == names::ask_all_text ||
         performative == names::ask_how_text;
}

/// Refuses arguments of `.send` in Jason's words; nothing: they can be sent.
std::optional<Outcome> refuse(ActionCall& call, Symbol performative, bool waits) {
  const Value to = call.arg(0);
  if (!to.is_atom() && !to.is_list() && !to.is_text()) {
    return call.wrong_arguments(
        fmt::format("TO parameter ('{}') must be an atom, a string or a list of receivers!",
                    brief_text(to, call.symbols())));
  }
  if (performative == names::empty) {
    return call.wrong_arguments(fmt::format("illocutionary force parameter ('{}') must be an atom!",
                                            brief_text(call.arg(1), call.symbols())));
  }
  if (waits && call.count() > 4 && !call.arg(4).is_number()) {
    return call.fail("internal_action",
                     fmt::format("The 5th parameter of send must be a number (timeout) and not "
                                 "'{}'!",
                                 brief_text(call.arg(4), call.symbols())));
  }
  return std::nullopt;
}

OutgoingMessage message_of(ActionCall& call, Symbol performative, bool waits) {
  OutgoingMessage message;
  message.performative = performative;
  message.content = call.arg(2);
  message.id =
      call.agent()->new_message_id(waits ? MessageId::Kind::question : MessageId::Kind::message);
  if (!waits && call.count() > 3) {
    message.in_reply_to = question_named(text_of(call.arg(3), call.symbols()));
  }
  return message;
}

/// Sends a message to one more receiver. Nothing: it is on its way.
std::optional<Outcome> send_to(Value receiver, OutgoingMessage& message, ActionCall& call) {
  if (!receiver.is_atom() && !receiver.is_text()) {
    return call.fail("internal_action",
                     fmt::format("The TO parameter ('{}') of the internal action 'send' is not an "
                                 "atom!",
                                 brief_text(receiver, call.symbols())));
  }
  std::string buffer;
  message.receiver_atom.reset();
  if (is_plain_atom(receiver)) {
    message.receiver_atom = receiver.atom_id();
  } else {
    message.receiver = name_of(receiver, call.symbols(), buffer);
  }
  if (call.agent()->host().send(*call.agent(), message)) return std::nullopt;
  return call.fail("receiver_not_found",
                   "there is no agent " + std::string(name_of(receiver, call.symbols(), buffer)));
}

/// Suspends the intention until `receivers` agents have answered the question.
Outcome await_answers(ActionCall& call, const OutgoingMessage& question, std::size_t receivers) {
  PendingAsk ask;
  ask.id = question.id;
  ask.answer = call.arg(3);
  ask.is_one = question.performative == names::ask_one_text;
  ask.to_many = call.arg(0).is_list();
  ask.awaited = receivers;
  const double timeout_ms = call.count() > 4 ? std::max(0.0, call.arg(4).as_number()) : -1;
  call.agent()->wait_for_answers(*call.intention(), std::move(ask), timeout_ms);
  return Outcome::suspended;
}

}  // namespace

Outcome send(ActionCall& call) {
  const Symbol performative = performative_of(call.arg(1), call.symbols());
  const bool waits = asks(performative) && call.count() > 3;
  if (const auto refused = refuse(call, performative, waits)) return *refused;
  const Value to = call.arg(0);
  const std::vector<Value> listed = to.is_list() ? elements(to) : std::vector<Value>{};
  const std::span<const Value> receivers = to.is_list() ? listed : std::span(&to, 1);
  OutgoingMessage message = message_of(call, performative, waits);
  for (const Value receiver : receivers) {
    if (const auto failed = send_to(receiver, message, call)) return *failed;
  }
  if (!waits) return Outcome::succeeded;
  if (receivers.empty()) return call.result(3, Value::empty_list());
  return await_answers(call, message, receivers.size());
}

Outcome broadcast(ActionCall& call) {
  const Symbol performative = performative_of(call.arg(0), call.symbols());
  if (performative == names::empty) {
    return call.wrong_arguments("illocutionary force argument must be an atom");
  }
  Agent& agent = *call.agent();
  OutgoingMessage message;
  message.performative = performative;
  message.content = call.arg(1);
  message.id = agent.new_message_id(MessageId::Kind::message);
  for (const std::string& name : agent.host().society().names()) {
    if (name == agent.name()) continue;
    message.receiver = name;
    (void)agent.host().send(agent, message);
  }
  return Outcome::succeeded;
}

Outcome kqml_answer(ActionCall& call) {
  std::vector<Value> found;
  const Value query = call.arg(0);
  if (!is_literal(query)) return Outcome::failed;
  // An open set of annotations takes those of the belief that answers.
  const Value rest = call.heap().variable();
  const LiteralParts parts = literal_parts(query);
  const Value open = call.heap().structure(parts.predicate, parts.args,
                                           call.heap().list(elements(parts.annots), rest));
  call.machine().solve_all_terms(open, [&] {
    const Value answer = call.unifier().fresh_copy(open);
    std::vector<Value> annots;
    for (const Value annot : elements(literal_parts(answer).annots)) {
      if (!annot.same_as(source_self().pair()->head) &&
          text_of(annot, call.symbols()) != "source(self)") {
        annots.push_back(annot);
      }
    }
    found.push_back(with_annotations(call.heap(), answer, call.heap().list(annots)));
    return true;
  });
  return call.many(std::make_unique<ValueSolutions>(1, std::move(found)));
}

}  // namespace jaywalk::actions
