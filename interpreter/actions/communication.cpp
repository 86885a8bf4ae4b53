#include <string>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::actions {

Outcome my_name(ActionCall& call) {
  return call.result(0, Value::atom(call.symbols().predicate(call.agent()->name(), 0)));
}

Outcome all_names(ActionCall& call) {
  std::vector<Value> names;
  for (const std::string& name : call.agent()->host().agent_names()) {
    names.push_back(Value::atom(call.symbols().predicate(name, 0)));
  }
  return call.result(0, call.heap().list(names));
}

Outcome send(ActionCall& call) {
  const Value performative = call.arg(1);
  if (!performative.is_atom()) return call.wrong_argument(1, "a performative");
  Agent& agent = *call.agent();
  OutgoingMessage message;
  message.performative = call.symbols().signature(performative.atom_id()).functor;
  message.content = call.arg(2);
  if (call.count() > 3) message.in_reply_to = text_of(call.arg(3), call.symbols());
  std::vector<Value> receivers{call.arg(0)};
  if (call.arg(0).is_list()) receivers = elements(call.arg(0));
  for (const Value receiver : receivers) {
    if (!receiver.is_atom() && !receiver.is_text()) {
      return call.wrong_argument(0, "an agent's name or a list of them");
    }
    const std::string name = text_of(receiver, call.symbols());
    message.receiver = name;
    if (!agent.host().send(agent, message)) {
      return call.fail("receiver_not_found", "there is no agent " + name);
    }
  }
  return Outcome::succeeded;
}

Outcome broadcast(ActionCall& call) {
  const Value performative = call.arg(0);
  if (!performative.is_atom()) return call.wrong_argument(0, "a performative");
  OutgoingMessage message;
  message.performative = call.symbols().signature(performative.atom_id()).functor;
  message.content = call.arg(1);
  call.agent()->host().broadcast(*call.agent(), message);
  return Outcome::succeeded;
}

Outcome kqml_answer(ActionCall& call) {
  std::vector<Value> found;
  const Value query = call.arg(0);
  if (!is_literal(query)) return Outcome::failed;
  // An open set of annotations takes those of the belief that answers.
  const Value rest = call.heap().variable();
  const LiteralParts parts = literal_parts(query);
  const Value open = call.heap().structure(
      parts.predicate, parts.args, call.heap().list(elements(parts.annots), rest));
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
