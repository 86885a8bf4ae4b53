#include "interpreter/actions/collections/collections.h"

namespace jaywalk::actions {
namespace {

using Queues = Collections<QueueObject>;

}  // namespace

Outcome queue_create(ActionCall& call) {
  if (!call.arg(0).is_variable()) return Outcome::failed;
  const bool priority = call.count() == 2 && text_of(call.arg(1), call.symbols()) == "priority";
  const auto order = priority ? QueueObject::Order::priority : QueueObject::Order::arrival;
  return call.result(0, made(call, std::make_unique<QueueObject>(order)));
}

Outcome queue_add(ActionCall& call) {
  QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  queue->add(kept(call, call.arg(1)), call.symbols());
  return within_limit(call, *queue);
}

Outcome queue_add_all(ActionCall& call) {
  QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  std::vector<Value> all;
  if (!collection_in(call.arg(1), all))
    return call.java_exception("the second argument is no list");
  for (const Value element : all) queue->add(kept(call, element), call.symbols());
  return within_limit(call, *queue);
}

Outcome queue_head(ActionCall& call) {
  const QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  return queue->size() == 0 ? Outcome::failed : call.result(1, queue->elements().front());
}

Outcome queue_remove(ActionCall& call) {
  QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  return queue->size() == 0 ? Outcome::failed : call.result(1, queue->take(call.symbols()));
}

Outcome queue_to_list(ActionCall& call) {
  const QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  const std::vector<Value> all(queue->elements().begin(), queue->elements().end());
  return call.result(1, call.heap().list(all));
}

Outcome queue_clear(ActionCall& call) { return Queues::clear(call); }

Outcome queue_copy(ActionCall& call) { return Queues::copy(call); }

}  // namespace jaywalk::actions
