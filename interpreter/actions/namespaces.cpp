// SPDX-License-Identifier: Apache-2.0
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
  if (!is_unsigned_atom(call.arg(0)) && !call.arg(0).is_variable()) {
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
  if (!is_unsigned_atom(call.arg(0))) return call.wrong_argument(0, "an atom (the namespace id).");
  if (!is_java_literal(call.arg(1))) return call.java_exception("the key is no atom");
  if (call.agent() == nullptr) return Outcome::failed;
  const Symbol ns = call.symbols().signature(call.arg(0).atom_id()).functor;
  const Value value = call.unifier().fresh_copy(call.arg(2));
  const Value key = call.unifier().fresh_copy(call.arg(1));
  call.agent()->beliefs().set_namespace_property({ns, key, value});
  call.heap().protect();
  return Outcome::succeeded;
}

Outcome namespace_get_prop(ActionCall& call) {
  if (!is_unsigned_atom(call.arg(0))) return call.wrong_argument(0, "an atom (the namespace id).");
  const Value key = call.arg(1);
  if (!is_java_literal(key)) return call.java_exception("the key is no atom");
  if (call.agent() == nullptr) return Outcome::failed;
  const Symbol ns = call.symbols().signature(call.arg(0).atom_id()).functor;
  std::vector<NamespaceProperty> found;
  for (const NamespaceProperty& property : call.agent()->beliefs().namespace_properties()) {
    if (property.ns == ns) found.push_back(property);
  }
  if (!key.is_variable()) {
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
