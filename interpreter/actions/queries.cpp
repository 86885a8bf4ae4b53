#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

std::vector<Value> collect(ActionCall& call) {
  std::vector<Value> found;
  call.solve(1, [&] {
    found.push_back(call.unifier().fresh_copy(call.applied(0)));
    return true;
  });
  return found;
}

}  // namespace

Outcome findall(ActionCall& call) {
  const std::vector<Value> found = collect(call);
  return call.result(2, call.heap().list(found));
}

Outcome setof(ActionCall& call) {
  const std::vector<Value> found = collect(call);
  return call.result(2, sorted_set(call.heap(), call.heap().list(found), call.symbols()));
}

Outcome count(ActionCall& call) {
  double number = 0;
  call.solve(0, [&] {
    ++number;
    return true;
  });
  return call.count() == 1 ? Outcome::succeeded : call.result(1, Value::number(number));
}

Outcome abolish(ActionCall& call) {
  Agent* const agent = call.agent();
  if (agent == nullptr) return Outcome::failed;
  Unifier& unifier = call.unifier();
  const Value pattern = call.arg(0);
  std::vector<std::pair<Relation*, std::int64_t>> matches;
  for (const auto& relation : agent->beliefs().relations()) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (row.fact.is_unset()) continue;
      const std::size_t trail = unifier.mark();
      if (unifier.unify(pattern, row.fact)) matches.emplace_back(relation.get(), seq);
      unifier.undo(trail);
    }
  }
  for (const auto& [relation, seq] : matches) {
    const Value fact =
        with_annotations(call.heap(), relation->row(seq).fact, Value::empty_list());
    agent->beliefs().erase(*relation, seq);
    agent->add_event({TriggerOperator::remove, TriggerKind::belief, fact, nullptr, 0});
  }
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions
