#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {

Outcome fail(ActionCall& call) {
  if (call.count() == 0) return Outcome::failed;
  for (const Value arg : call.args()) call.error.annots.push_back(deref(arg));
  return call.fail("internal_action", "fail");
}

Outcome wait(ActionCall& call) {
  if (!call.arg(0).is_number()) return call.wrong_argument(0, "a number of milliseconds");
  const double ms = call.arg(0).as_number();
  Agent& agent = *call.agent();
  agent.suspend(*call.intention(), Intention::State::waiting, "wait");
  agent.wait_for_timer(*call.intention(), ms > 0 ? ms : 0);
  return Outcome::suspended;
}

Outcome stop_mas(ActionCall& call) {
  const Value code = call.count() == 2 ? call.arg(1) : Value::number(0);
  call.agent()->host().stop(code.is_number() ? static_cast<int>(code.as_number()) : 0);
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions
