// SPDX-License-Identifier: Apache-2.0
// Message delivery, from sender to recipients' mailboxes. Messages arrive when a round is over, in
// the order in which they were sent. Until then their contents are in heaps of their own: an
// agent's room in a round must not depend on the agents that reason before it.

#include <array>

#include <fmt/format.h>

#include "interpreter/agent/step_guard.h"
#include "interpreter/mas/system.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {

namespace {

// Into a heap whose owner has not asked for it: up to `most` bytes more than it may have.
Value copy_content(Value content, Heap& heap, std::size_t most) {
  try {
    return transfer(content, heap);
  } catch (const HeapExhausted&) {
    const MemoryReserve lent(heap, most);
    return transfer(content, heap);
  }
}

}  // namespace

// Messages sent in a round count towards their sender's memory during this round, then towards the
// receiver's. A receiver without room gets no more messages; whether it has room is settled between
// rounds, so that neither order nor threads matter.
void Mas::Implementation::require_room_for_message(AgentRecord& sender,
                                                   const AgentRecord& receiver) {
  if (receiver.is_full) {
    throw QueryLimit{
        fmt::format("agent {} has no memory left for messages", receiver.agent->name())};
  }
  if (sender.sent_before != deliveries_) {
    sender.sent_before = deliveries_;
    sender.sent_bytes = 0;
  }
  sender.sent_bytes += sizeof(Message);
  sender.agent->heap().require_bytes(2 * sender.sent_bytes);
}

// Names become atoms when they are first needed: most agents of a large system send nothing.
const AgentRecord& Mas::Implementation::named(AgentRecord& record) {
  if (!record.name) {
    record.name = symbols_.predicate(record.agent->name(), 0);
    record.name_text = symbols_.text(symbols_.symbol(record.agent->name()));
  }
  return record;
}

AgentRecord* Mas::Implementation::receiver_of(const OutgoingMessage& message, Agent& sender) {
  if (!message.receiver_atom) {
    return message.receiver == "self" ? &table_.of(sender) : table_.find(message.receiver);
  }
  const Predicate atom = *message.receiver_atom;
  if (atom == predicates::self) return &table_.of(sender);
  if (AgentRecord* const known = table_.known_as(atom)) return known;
  AgentRecord* const found = table_.find(symbols_.functor(atom));
  if (found != nullptr && block_of(sender) == nullptr) table_.remember(atom, *found);
  return found;
}

bool Mas::Implementation::send(Agent& sender, const OutgoingMessage& message) {
  sender.turn().has_business = true;
  AgentRecord* const receiver = receiver_of(message, sender);
  if (receiver == nullptr) return false;
  AgentRecord& from = table_.of(sender);
  require_room_for_message(from, *receiver);
  Message copy;
  if (receiver->agent.get() == &sender) {
    copy.sender = "self";
    copy.sender_atom = predicates::self;
  } else {
    const AgentRecord& own = named(from);
    copy.sender = own.name_text;
    copy.sender_atom = *own.name;
  }
  copy.performative = message.performative;
  copy.id = message.id;
  copy.in_reply_to = message.in_reply_to;
  // The message's size counts towards the sender's limit: terms that share their parts are larger
  // as copies.
  if (ParallelBlock* const block = this->block_of(sender)) {
    Outbox& outbox = block->outbox;
    const std::size_t before = outbox.heap.bytes();
    copy.content = copy_content(message.content, outbox.heap, options_.max_agent_bytes);
    from.sent_bytes += outbox.heap.bytes() - before;
    outbox.add(Outbox::Letter{receiver->number, copy});
  } else {
    const std::size_t before = mail_ ? mail_->bytes() : 0;
    post_content(*receiver, copy, message.content);
    from.sent_bytes += (mail_ ? mail_->bytes() : 0) - before;
  }
  return true;
}

void Mas::Implementation::tell_of_provider(const std::string& subscriber,
                                           const std::string& provider,
                                           const std::string& service) {
  AgentRecord* const receiver = table_.find(subscriber);
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

void Mas::Implementation::post(AgentRecord& receiver, const Message& message) {
  turn_.has_business = true;
  receiver.agent->circumstance().arriving.push_back(message);
  if (receiver.has_mail) return;
  receiver.has_mail = true;
  receivers_.push_back(receiver.number);
}

// Variables and collections are numbered by the heap that they come into, and people see the
// numbers: those of the receiver's own in this round come before.
void Mas::Implementation::post_content(AgentRecord& receiver, Message message, Value content) {
  if (content.is_number() || content.is_atom()) {
    message.content = content;  // it is in no heap
    post(receiver, message);
    return;
  }
  if (!mail_) {
    mail_.emplace();
    mail_->set_limit(0);
  }
  const MemoryReserve lent(*mail_, options_.max_agent_bytes);
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
    copy = copy_content(content, receiver.heap(), receiver.heap().limit());
    return true;
  });
  if (!arrived) receiver.log("a message was too large: " + error.message);
  return copy;
}

void Mas::Implementation::look_at_full() {
  std::erase_if(full_, [this](std::uint32_t number) {
    AgentRecord& receiver = table_[number];
    if (!receiver.is_leaving) look_for_room(receiver);
    return receiver.is_leaving || !receiver.is_full;
  });
}

bool Mas::Implementation::deliver_messages() {
  ++deliveries_;
  if (!full_.empty()) look_at_full();
  if (receivers_.empty()) return false;
  for (const Content& each : contents_) {
    AgentRecord& receiver = table_[each.receiver];
    if (receiver.is_leaving) continue;
    receiver.agent->circumstance().arriving[each.message].content =
        hand_over(each.content, *receiver.agent);
  }
  contents_.clear();
  if (mail_ && mail_->is_short()) mail_.reset();  // its failures are forgotten, too
  if (mail_) mail_->clear();
  for (const std::uint32_t number : receivers_) {
    AgentRecord& receiver = table_[number];
    receiver.has_mail = false;
    if (receiver.is_leaving) continue;
    auto& arriving = receiver.agent->circumstance().arriving;
    for (const Message& message : arriving) receiver.agent->receive(message);
    receiver.agent->heap().note_other_bytes(arriving.size() * sizeof(Message));
    arriving.clear();
    if (!receiver.is_full) {
      look_for_room(receiver);
      if (receiver.is_full) full_.push_back(number);
    }
    wake(receiver);
  }
  receivers_.clear();
  return true;
}

}  // namespace jaywalk
