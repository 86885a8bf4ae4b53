// SPDX-License-Identifier: Apache-2.0
// Messages as far as they are not handled by plans, and texts about events and plans.

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/goals.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

constexpr std::string_view kMessagePrefix = "mid";
constexpr std::string_view kQuestionPrefix = "samid";
// The texts become atoms, which are never freed: so their number is limited.
constexpr std::uint32_t kMessageIds = 65'536;
constexpr std::string_view kWaitsForAnswer = "waiting_ask";

}  // namespace

std::string text_of(MessageId id) {
  if (id.kind == MessageId::Kind::none) return {};
  const bool is_question = id.kind == MessageId::Kind::question;
  return std::string(is_question ? kQuestionPrefix : kMessagePrefix) + std::to_string(id.number);
}

MessageId question_named(std::string_view text) {
  if (!text.starts_with(kQuestionPrefix)) return {};
  text.remove_prefix(kQuestionPrefix.size());
  MessageId id{MessageId::Kind::question, 0};
  const char* const end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, id.number);
  const bool is_exact = problem == std::errc() && rest == end && text.front() != '0';
  if (!is_exact || id.number > kMessageIds) id.number = 0;
  return id;
}

// Rule ProcMsg: one message a cycle.
void Agent::process_message() {
  const Message message = circumstance_.mailbox.front();
  circumstance_.mailbox.pop_front();
  std::unique_ptr<ActionError> error;
  const bool handled = guarded(error, [&] {
    if (answer_arrived(message)) return true;
    const bool is_free = customisation_ == nullptr || !customisation_->accepts_message;
    if (is_free || customisation_->accepts_message(*this, message)) handle_message(message);
    return true;
  });
  if (handled) return;
  if (error->limit != ReachedLimit::memory || tells_of_memory()) {
    log(fmt::format("a message of {} is lost: {}", message.sender, error->message));
  }
  report_limit(*error, fmt::format("a message of {}", message.sender));
}

// The usual performatives, for an agent without plans of its own for messages. False: another one.
bool Agent::handle_at_once(Symbol performative, Value content, Value sender) {
  const bool is_rule = is_form(content, Form::rule);
  const auto told = [&] { return add_source(as_literal(content), sender); };
  if (performative == names::achieve_text) {
    add_goal(told());
  } else if (performative == names::tell_text && is_rule) {
    add_rule(add_source(content, sender), Place::front);
  } else if (performative == names::tell_text) {
    add_belief(told(), Place::front, nullptr);
  } else if (performative == names::untell_text && is_rule) {
    remove_like(told());
  } else if (performative == names::untell_text) {
    (void)remove_belief(told(), nullptr);
  } else if (performative == names::signal_text) {
    const Value literal = told();
    const Value signal = Value::atom(symbols_.predicate("signal", 0));
    const Value annots = union_of(heap_, literal_parts(literal).annots,
                                  heap_.pair(signal, Value::empty_list()), symbols_);
    add_event({TriggerOperator::add, TriggerKind::belief, with_annotations(heap_, literal, annots),
               nullptr, 0});
  } else {
    return false;
  }
  return true;
}

void Agent::handle_message(const Message& message) {
  const Value sender = Value::atom(message.sender_atom);
  heap_.require_room();
  if (is_literal(as_literal(message.content)) && !settings_.messages_by_plans &&
      !library_->has_own_message_plans() &&
      handle_at_once(message.performative, message.content, sender)) {
    return;
  }
  const std::string id = text_of(message.id);
  const std::array<Value, 4> args{
      sender, Value::atom(symbols_.predicate(symbols_.text(message.performative), 0)),
      message.content,
      Value::atom(symbols_.predicate(id.empty() ? kMessagePrefix : std::string_view(id), 0))};
  add_goal(heap_.structure(predicates::kqml_received, args));
}

MessageId Agent::new_message_id(MessageId::Kind kind) {
  while (true) {
    last_message_ = last_message_ % kMessageIds + 1;
    const MessageId id{kind, last_message_};
    const auto& asks = circumstance_.asks;
    const bool in_use =
        std::any_of(asks.begin(), asks.end(), [&](const PendingAsk& ask) { return ask.id == id; });
    if (!in_use) return id;
  }
}

void Agent::wait_for_answers(Intention& intention, PendingAsk ask, double timeout_ms) {
  // An earlier question of this intention is no longer waited for (its goal was ended meanwhile).
  erase_if(circumstance_.asks,
           [&](const PendingAsk& other) { return other.intention == &intention; });
  if (timeout_ms >= 0) {
    ask.timer = new_token();
    host_.set_timer(*this, host_.now_ms() + timeout_ms, ask.timer);
  }
  ask.intention = &intention;
  record_bindings(intention, 0);
  suspend(intention, Intention::State::waiting, std::string(kWaitsForAnswer));
  if (library_->has_goal_state_plans()) {
    signal_top_state(intention, "waiting", Waits(*this).reason(intention));
  }
  heap_.note_other_bytes(sizeof(PendingAsk));
  circumstance_.asks.push_back(std::move(ask));
}

// Whether the message answers a question that an intention waits, or has waited, for.
bool Agent::answer_arrived(const Message& message) {
  if (message.in_reply_to.kind != MessageId::Kind::question) return false;
  auto& asks = circumstance_.asks;
  const auto found = std::find_if(asks.begin(), asks.end(), [&](const PendingAsk& ask) {
    return ask.id == message.in_reply_to;
  });
  if (found == asks.end()) return true;  // too late
  // Its own answer has its name as the source, where its other messages to itself have `self`.
  const bool is_own = message.sender_atom == predicates::self;
  const Value sender = Value::atom(is_own ? symbols_.predicate(name(), 0) : message.sender_atom);
  Value answer = message.content;
  if (found->is_one && message.performative == names::untell_text) {
    answer = Value::atom(predicates::falsity);
  } else if (answer.is_pair()) {
    std::vector<Value> answers;
    for (Value rest = answer; rest.is_pair(); rest = deref(rest.pair()->tail)) {
      answers.push_back(add_source(deref(rest.pair()->head), sender));
    }
    answer = heap_.list(answers);
  } else {
    answer = add_source(answer, sender);
  }
  found->answers.push_back(answer);
  if (found->answers.size() < found->awaited) return true;
  const PendingAsk ask = std::move(*found);
  asks.erase(found);
  if (ask.to_many) answer = heap_.list(ask.answers);
  end_ask(ask, answer);
  return true;
}

std::optional<PendingAsk> Agent::take_ask(MessageId question) {
  auto& asks = circumstance_.asks;
  const auto found = std::find_if(asks.begin(), asks.end(),
                                  [&](const PendingAsk& ask) { return ask.id == question; });
  if (found == asks.end()) return std::nullopt;
  PendingAsk ask = std::move(*found);
  asks.erase(found);
  return ask;
}

void Agent::answer_question(MessageId question, Value answer) {
  if (const auto ask = take_ask(question)) end_ask(*ask, answer);
}

void Agent::fail_question(MessageId question, const ActionError& error) {
  if (const auto ask = take_ask(question)) fail_waiting(*ask->intention, error);
}

bool Agent::ask_timed_out(std::uint64_t token) {
  auto& asks = circumstance_.asks;
  const auto found = std::find_if(asks.begin(), asks.end(),
                                  [&](const PendingAsk& ask) { return ask.timer == token; });
  if (found == asks.end()) return false;
  PendingAsk ask = std::move(*found);
  asks.erase(found);
  ActionError error;
  const bool ended = guarded(error, [&] {
    const Value answer =
        ask.to_many ? heap_.list(ask.answers) : Value::atom(symbols_.predicate("timeout", 0));
    end_ask(ask, answer);
    return true;
  });
  if (!ended) fail_waiting(*ask.intention, error);
  return true;
}

bool Agent::expects_timer(std::uint64_t token) {
  const Circumstance& c = circumstance_;
  const auto is_its = [&](const auto& each) { return each.first == token; };
  return std::any_of(c.waits.begin(), c.waits.end(),
                     [&](const Wait& wait) { return wait.id == token; }) ||
         std::any_of(c.asks.begin(), c.asks.end(),
                     [&](const PendingAsk& ask) { return ask.timer == token; }) ||
         std::any_of(c.scheduled.begin(), c.scheduled.end(), is_its) ||
         std::any_of(c.deadlines.begin(), c.deadlines.end(), [&](const GoalDeadline& deadline) {
           return deadline.token == token && Goals(*this).is_pursued(deadline.goal);
         });
}

void Agent::end_ask(const PendingAsk& ask, Value answer) {
  Intention& intention = *ask.intention;
  if (intention.state != Intention::State::waiting || intention.reason != kWaitsForAnswer) return;
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  if (unifier.unify(ask.answer, answer)) {
    record_bindings(intention, trail);
    signal_top_state(intention, "executing", Value());
    resume(intention);
    return;
  }
  ActionError error;
  error.id = "ask_failed";
  error.message = fmt::format(
      "reply of an ask message ('{}') does not unify with fourth argument of .send ('{}')",
      brief_text(answer, symbols_), brief_text(ask.answer, symbols_));
  fail_waiting(intention, error);
}

Value Agent::add_source(Value literal, Value sender) {
  // A plan's label has its sources, a rule's head those of the rule.
  if (is_form(literal, Form::plan) || is_form(literal, Form::rule)) {
    const Structure& code = *literal.structure();
    std::vector<Value> parts(code.arg_span().begin(), code.arg_span().end());
    parts[0] = add_source(deref(parts[0]), sender);
    return heap_.structure(code.predicate(), parts, code.annots(), code.form());
  }
  if (!is_literal(literal)) return literal;
  if (literal_parts(literal).annots.is_empty_list()) {
    const Value source = heap_.structure(predicates::source, std::span(&sender, 1));
    return with_annotations(heap_, literal, heap_.pair(source, Value::empty_list()));
  }
  std::vector<Value> sources;
  std::vector<Value> kept;
  for (Value a = deref(literal_parts(literal).annots); a.is_pair(); a = deref(a.pair()->tail)) {
    const Value annot = deref(a.pair()->head);
    const bool is_source =
        annot.is_structure() && annot.structure()->predicate() == predicates::source;
    (is_source ? sources : kept).push_back(annot);
  }
  const Value nested = sorted_set(heap_, heap_.list(sources), symbols_);
  kept.push_back(heap_.structure(predicates::source, std::span(&sender, 1), nested));
  return with_annotations(heap_, literal, sorted_set(heap_, heap_.list(kept), symbols_));
}

std::string Agent::trigger_text(const Event& event) const {
  return trigger_operator(event.op, event.kind) + brief_text(event.literal, symbols_);
}

std::string Agent::plan_name(const Plan& plan) const {
  std::string name = "the plan";
  if (is_literal(plan.label)) {
    const std::string_view label = symbols_.functor(literal_parts(plan.label).predicate);
    if (!label.starts_with("p__")) name = fmt::format("plan @{}", label);
  }
  return plan.line == 0 ? name : fmt::format("{} at {}:{}", name, plan.file, plan.line);
}

}  // namespace jaywalk
