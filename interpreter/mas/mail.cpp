// Messages, from whom sends them to the mailboxes of whom they are for. They arrive when a round is
// over, in the order in which they were sent.

#include <array>

#include "interpreter/agent/step_guard.h"
#include "interpreter/mas/system.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {

// Names become atoms when they are first needed: most agents of a large system send nothing.
const Resident& Mas::Implementation::named(Resident& resident) {
  if (!resident.name) {
    resident.name = symbols_.predicate(resident.agent->name(), 0);
    resident.name_text = symbols_.text(symbols_.symbol(resident.agent->name()));
  }
  return resident;
}

Resident* Mas::Implementation::receiver_of(const OutgoingMessage& message, const Agent& sender) {
  if (!message.receiver_atom) {
    return message.receiver == "self" ? &residents_.of(sender) : residents_.find(message.receiver);
  }
  const Predicate atom = *message.receiver_atom;
  if (atom == predicates::self) return &residents_.of(sender);
  if (Resident* const known = residents_.known_as(atom)) return known;
  Resident* const found = residents_.find(symbols_.functor(atom));
  if (found != nullptr && beside_ == nullptr) residents_.remember(atom, *found);
  return found;
}

bool Mas::Implementation::send(Agent& sender, const OutgoingMessage& message) {
  has_business_ = true;
  Resident* const receiver = receiver_of(message, sender);
  if (receiver == nullptr) return false;
  Message copy;
  if (receiver->agent.get() == &sender) {
    copy.sender = "self";
    copy.sender_atom = predicates::self;
  } else {
    const Resident& own = named(residents_.of(sender));
    copy.sender = own.name_text;
    copy.sender_atom = *own.name;
  }
  copy.performative = message.performative;
  copy.id = message.id;
  copy.in_reply_to = message.in_reply_to;
  // Variables and collections are numbered by the heap that they come into, and people see the
  // numbers. So they come into the receiver's when they are delivered, after its own of this round.
  const bool is_plain = message.content.is_closed() && !sender.heap().has_objects();
  if (beside_ != nullptr) {
    Outbox& outbox = beside_->outbox;
    copy.content = transfer(message.content, outbox.heap);
    outbox.add(Outbox::Letter{receiver->number, copy, is_plain});
  } else if (is_plain) {
    copy.content = transfer(message.content, receiver->agent->heap());
    post(*receiver, copy);
  } else {
    post_later(*receiver, copy, message.content);
  }
  return true;
}

void Mas::Implementation::tell_of_provider(const std::string& subscriber,
                                           const std::string& provider,
                                           const std::string& service) {
  Resident* const receiver = residents_.find(subscriber);
  if (receiver == nullptr) return;
  Heap& heap = receiver->agent->heap();
  const std::array<Value, 2> args{Value::atom(symbols_.predicate(provider, 0)), heap.text(service)};
  Message message;
  message.sender = "df";
  message.sender_atom = symbols_.predicate(message.sender, 0);
  message.performative = names::tell_text;
  message.content = heap.structure(symbols_.predicate("provider", 2), args);
  post(*receiver, message);
}

void Mas::Implementation::post(Resident& receiver, const Message& message) {
  has_business_ = true;
  receiver.agent->circumstance().arriving.push_back(message);
  if (receiver.has_mail) return;
  receiver.has_mail = true;
  receivers_.push_back(receiver.number);
}

void Mas::Implementation::post_later(Resident& receiver, Message message, Value content) {
  if (!mail_) mail_.emplace();
  contents_.push_back(
      {receiver.number, receiver.agent->circumstance().arriving.size(), transfer(content, *mail_)});
  message.content = Value();
  post(receiver, message);
}

// A content that is too large for its receiver is lost: `false` arrives.
Value Mas::Implementation::hand_over(Value content, Agent& receiver) {
  Value copy = Value::atom(predicates::falsity);
  ActionError error;
  const bool arrived = guarded(error, [&] {
    copy = transfer(content, receiver.heap());
    return true;
  });
  if (!arrived) receiver.log("a message was too large: " + error.message);
  return copy;
}

bool Mas::Implementation::deliver_messages() {
  if (receivers_.empty()) return false;
  for (const Content& each : contents_) {
    Resident& receiver = residents_[each.receiver];
    if (receiver.is_leaving) continue;
    receiver.agent->circumstance().arriving[each.message].content =
        hand_over(each.content, *receiver.agent);
  }
  contents_.clear();
  mail_.reset();
  for (const std::uint32_t number : receivers_) {
    Resident& receiver = residents_[number];
    receiver.has_mail = false;
    if (receiver.is_leaving) continue;
    auto& arriving = receiver.agent->circumstance().arriving;
    for (const Message& message : arriving) receiver.agent->receive(message);
    arriving.clear();
    wake(receiver);
  }
  receivers_.clear();
  return true;
}

}  // namespace jaywalk
