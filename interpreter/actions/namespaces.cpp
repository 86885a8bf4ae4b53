#include <algorithm>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::actions {
namespace {

Value atom_of(SymbolTable& symbols, Symbol name) {
  return Value::atom(symbols.predicate(Signature{.functor = name}));
}

}  // namespace

Outcome namespaces(ActionCall& call) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  if (!call.arg(0).is_atom() && !call.arg(0).is_variable()) {
    return call.wrong_argument(0, "an atom or variable.");
  }
  std::vector<Symbol> names{names::default_ns};
  const auto add = [&](Symbol ns) {
    if (std::find(names.begin(), names.end(), ns) == names.end()) names.push_back(ns);
  };
  for (const auto& relation : agent->beliefs().relations()) {
    add(call.symbols().signature(relation->predicate()).ns);
  }
  for (const NamespaceProperty& property : agent->beliefs().namespace_properties()) {
    add(property.ns);
  }
  std::vector<Value> all;
  for (const Symbol name : names) all.push_back(atom_of(call.symbols(), name));
  return call.many(std::make_unique<ValueSolutions>(0, std::move(all)));
}

Outcome namespace_set_prop(ActionCall& call) {
  if (!call.arg(0).is_atom()) return call.wrong_argument(0, "an atom (the namespace id).");
  if (!call.arg(1).is_atom()) return call.wrong_argument(1, "an atom, the key");
  if (call.agent() == nullptr) return Outcome::failed;
  const Symbol ns = call.symbols().signature(call.arg(0).atom_id()).functor;
  const Value value = call.unifier().fresh_copy(call.arg(2));
  call.agent()->beliefs().set_namespace_property({ns, call.arg(1), value});
  call.heap().protect();
  return Outcome::succeeded;
}

Outcome namespace_get_prop(ActionCall& call) {
  if (!call.arg(0).is_atom()) return call.wrong_argument(0, "an atom (the namespace id).");
  const Value key = call.arg(1);
  if (!key.is_atom() && !key.is_variable()) return call.wrong_argument(1, "an atom or a variable");
  if (call.agent() == nullptr) return Outcome::failed;
  const Symbol ns = call.symbols().signature(call.arg(0).atom_id()).functor;
  std::vector<NamespaceProperty> found;
  for (const NamespaceProperty& property : call.agent()->beliefs().namespace_properties()) {
    if (property.ns == ns) found.push_back(property);
  }
  if (key.is_atom()) {
    const auto known = std::find_if(found.begin(), found.end(),
                                    [&](const NamespaceProperty& p) { return p.key.same_as(key); });
    if (known != found.end()) {
      return call.count() > 2 ? call.result(2, known->value) : Outcome::succeeded;
    }
    // Without a default Jason says yes and gives no value.
    return call.count() == 4 ? call.result(2, call.arg(3)) : Outcome::succeeded;
  }
  return each(call, [found = std::move(found), next = std::size_t{0}](ActionCall& inner) mutable {
    while (next < found.size()) {
      const NamespaceProperty& property = found[next++];
      const std::size_t trail = inner.unifier().mark();
      if (inner.unify(1, property.key) && (inner.count() < 3 || inner.unify(2, property.value))) {
        return true;
      }
      inner.unifier().undo(trail);
    }
    return false;
  });
}

}  // namespace jaywalk::actions
