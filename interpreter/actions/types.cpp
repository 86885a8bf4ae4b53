#include "interpreter/actions/actions.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

Outcome when(bool holds) { return holds ? Outcome::succeeded : Outcome::failed; }

bool is_code(Value value) {
  if (!value.is_structure()) return false;
  const Form form = value.structure()->form();
  return form != Form::expression && form != Form::decorated;
}

}  // namespace

Outcome atom(ActionCall& call) {
  const Value value = call.arg(0);
  return when(value.is_atom() && !call.symbols().signature(value.atom_id()).negated);
}

Outcome ground(ActionCall& call) { return when(is_ground(call.arg(0))); }
Outcome list(ActionCall& call) { return when(call.arg(0).is_list()); }
Outcome literal(ActionCall& call) { return when(call.arg(0).is_atom() || is_code(call.arg(0))); }
Outcome number(ActionCall& call) { return when(call.arg(0).is_number()); }
Outcome string(ActionCall& call) { return when(call.arg(0).is_text()); }
Outcome structure(ActionCall& call) { return when(call.arg(0).is_list() || is_code(call.arg(0))); }

}  // namespace jaywalk::actions
