#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {

std::string text_of(Value value, const SymbolTable& symbols) {
  std::string text;
  value = deref(value);
  if (value.is_text()) {
    text = value.text()->view();
  } else {
    append_term(text, value, symbols);
  }
  return text;
}

Outcome print(ActionCall& call) {
  std::string text;
  for (const Value arg : call.args()) append_argument(text, arg, call.symbols());
  if (call.agent() != nullptr) call.agent()->host().print(*call.agent(), text);
  return Outcome::succeeded;
}

Outcome println(ActionCall& call) { return print(call); }

}  // namespace jaywalk::actions
