// SPDX-License-Identifier: Apache-2.0
// Agents that come and go; the yellow pages: which agent offers which service; the end of the run.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/agent/surroundings/services.h"

namespace jaywalk::actions {
namespace {

/// Java classes that do what every agent of ours does.
constexpr std::array<std::string_view, 6> kOwnClasses = {"Agent",
                                                         "jason.asSemantics.Agent",
                                                         "AgArch",
                                                         "jason.architecture.AgArch",
                                                         "jason.bb.DefaultBeliefBase",
                                                         "DefaultBeliefBase"};

/// The first of the options agentClass(C), agentArchClass(C), beliefBaseClass(C) that only Java
/// could follow; empty if there is none.
std::string java_class_in(Value options, const SymbolTable& symbols) {
  for (const Value option : elements(options)) {
    if (!option.is_structure() || option.structure()->arity == 0) continue;
    std::string name = text_of(deref(option.structure()->arg(0)), symbols);
    if (std::find(kOwnClasses.begin(), kOwnClasses.end(), name) == kOwnClasses.end()) return name;
  }
  return {};
}

// As Jason, which names an agent after the variable that is to hold its name.
std::string name_for(Value variable, const SymbolTable& symbols) {
  std::string name(symbols.text(variable.variable()->name()));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto letter =
      std::find_if(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
  name.erase(name.begin(), letter);
  return name.empty() ? "agent" : name;
}

bool is_name(Value value) { return value.is_atom() || value.is_text(); }

// The service that the first of `count` arguments names; a second one is its type.
Service service_of(ActionCall& call, std::size_t count) {
  Service service;
  service.name = text_of(call.arg(0), call.symbols());
  if (count > 1) service.type = text_of(call.arg(1), call.symbols());
  return service;
}

ServiceDirectory& services(ActionCall& call) { return call.agent()->host().society().services(); }

}  // namespace

Outcome my_name(ActionCall& call) {
  return call.result(0, Value::atom(call.symbols().predicate(call.agent()->name(), 0)));
}

Outcome all_names(ActionCall& call) {
  std::vector<Value> names;
  for (const std::string& name : call.agent()->host().society().names()) {
    names.push_back(Value::atom(call.symbols().predicate(name, 0)));
  }
  return call.result(0, call.heap().list(names));
}

Outcome create_agent(ActionCall& call) {
  const Value name = call.arg(0);
  if (!is_name(name) && !name.is_variable()) return call.wrong_argument(0, "a name or a variable");
  if (call.count() > 1 && !call.arg(1).is_text()) return call.wrong_argument(1, "a string");
  if (call.count() > 2) {
    if (!call.arg(2).is_list()) return call.wrong_argument(2, "a list");
    const std::string java = java_class_in(call.arg(2), call.symbols());
    if (!java.empty()) {
      return call.fail("wrong_arguments", java + " is a Java class, which cannot be run here");
    }
  }
  const bool is_open = name.is_variable();
  const Society::Creation made = call.agent()->host().society().create(
      is_open ? name_for(name, call.symbols()) : text_of(name, call.symbols()),
      call.count() > 1 ? text_of(call.arg(1), call.symbols()) : std::string());
  if (!made.error.empty()) return call.fail("internal_action", made.error);
  return is_open ? call.result(0, call.heap().text(made.name)) : Outcome::succeeded;
}

Outcome clone(ActionCall& call) {
  if (!is_name(call.arg(0))) return call.wrong_argument(0, "a name");
  Agent& agent = *call.agent();
  const Society::Creation made =
      agent.host().society().clone(agent, text_of(call.arg(0), call.symbols()));
  return made.error.empty() ? Outcome::succeeded : call.fail("internal_action", made.error);
}

Outcome kill_agent(ActionCall& call) {
  if (!is_name(call.arg(0))) return call.wrong_argument(0, "an agent's name");
  double deadline_ms = 0;
  if (call.count() > 1) {
    if (!call.arg(1).is_number()) return call.wrong_argument(1, "a number of milliseconds");
    deadline_ms = call.arg(1).as_number();
  }
  Society& society = call.agent()->host().society();
  return society.kill(text_of(call.arg(0), call.symbols()), deadline_ms) ? Outcome::succeeded
                                                                         : Outcome::failed;
}

Outcome stop_mas(ActionCall& call) {
  double deadline_ms = 0;
  if (call.count() > 0) {
    if (!call.arg(0).is_number()) return call.wrong_argument(0, "a number of milliseconds");
    deadline_ms = call.arg(0).as_number();
  }
  // `.stopMAS(0, false)` leaves Jason's process running; the run ends all the same.
  int exit_code = 0;
  if (call.count() > 1 && call.arg(1).is_number()) {
    exit_code = static_cast<int>(std::clamp(call.arg(1).as_number(), -255.0, 255.0));
  }
  call.agent()->host().society().stop(*call.agent(), deadline_ms, exit_code);
  return Outcome::succeeded;
}

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
