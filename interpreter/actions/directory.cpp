// The yellow pages: which agent offers which service.

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/agent/surroundings/services.h"

namespace jaywalk::actions {
namespace {

// The service that the first of `count` arguments names; a second one is its type.
Service service_of(ActionCall& call, std::size_t count) {
  Service service;
  service.name = text_of(call.arg(0), call.symbols());
  if (count > 1) service.type = text_of(call.arg(1), call.symbols());
  return service;
}

ServiceDirectory& services(ActionCall& call) { return call.agent()->host().society().services(); }

}  // namespace

Outcome df_register(ActionCall& call) {
  services(call).add(call.agent()->name(), service_of(call, call.count()));
  return Outcome::succeeded;
}

Outcome df_deregister(ActionCall& call) {
  services(call).remove(call.agent()->name(), service_of(call, call.count()));
  return Outcome::succeeded;
}

Outcome df_search(ActionCall& call) {
  std::vector<Value> providers;
  for (const std::string& name : services(call).search(service_of(call, call.count() - 1))) {
    providers.push_back(Value::atom(call.symbols().predicate(name, 0)));
  }
  return call.result(call.count() - 1, call.heap().list(providers));
}

Outcome df_subscribe(ActionCall& call) {
  services(call).subscribe(call.agent()->name(), service_of(call, call.count()));
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions
