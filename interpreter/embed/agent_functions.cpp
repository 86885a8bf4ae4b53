// SPDX-License-Identifier: Apache-2.0
#include "interpreter/embed/agent_functions.h"

#include <utility>
#include <vector>

#include "interpreter/agent/agent.h"

namespace jaywalk {

const std::string& AgentView::name() const { return agent_->name(); }
Terms AgentView::terms() const { return {agent_->heap(), agent_->symbols()}; }
double AgentView::random() { return agent_->random().next_double(); }

AgentView Revision::agent() const { return AgentView(revision_->agent()); }
bool Revision::is_addition() const { return revision_->kind() == BeliefRevision::Kind::add; }
Value Revision::literal() const { return revision_->literal(); }
bool Revision::accept() { return revision_->accept(); }
bool Revision::add(Value literal) { return revision_->add(literal); }
bool Revision::remove(Value literal) { return revision_->remove(literal); }

EventView view_of(const Event& event) {
  EventView view;
  switch (event.kind) {
    case TriggerKind::belief:
      view.kind = EventView::Kind::belief;
      break;
    case TriggerKind::achieve:
      view.kind = EventView::Kind::achievement_goal;
      break;
    case TriggerKind::test:
      view.kind = EventView::Kind::test_goal;
      break;
  }
  switch (event.op) {
    case TriggerOperator::add:
      view.change = EventView::Change::added;
      break;
    case TriggerOperator::remove:
      view.change = EventView::Change::removed;
      break;
    case TriggerOperator::goal_state:
      view.change = EventView::Change::state;
      break;
  }
  view.literal = event.literal;
  view.is_internal = event.intention != nullptr;
  return view;
}

IntentionView view_of(const Intention& intention) {
  return {.number = intention.id,
          .label = intention.is_finished() ? Value() : intention.top().plan->label};
}

namespace {

// Views of the elements of an engine's list, which are objects or pointers.
template <class View, class List, class Viewed>
std::vector<View> views_of(const List& list, Viewed viewed) {
  std::vector<View> views;
  views.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) views.push_back(viewed(list[i]));
  return views;
}

void set_selections(const AgentClass& own, Customisation& engine) {
  if (own.select_event) {
    engine.select_event = [select = own.select_event](Agent& agent, const Ring<Event>& events) {
      return select(AgentView(agent),
                    views_of<EventView>(events, [](const Event& event) { return view_of(event); }));
    };
  }
  if (own.select_option) {
    engine.select_option = [select = own.select_option](Agent& agent, const Event& event,
                                                        std::span<const Option> options) {
      return select(AgentView(agent), view_of(event),
                    views_of<OptionView>(options, [](const Option& option) {
                      return OptionView{.label = option.plan->label, .values = option.values};
                    }));
    };
  }
  if (own.select_intention) {
    engine.select_intention = [select = own.select_intention](Agent& agent,
                                                              const Ring<Intention*>& ready) {
      return select(AgentView(agent), views_of<IntentionView>(ready, [](const Intention* each) {
                      return view_of(*each);
                    }));
    };
  }
}

}  // namespace

std::shared_ptr<const Customisation> customisation_of(AgentClass functions) {
  Customisation engine;
  set_selections(functions, engine);
  if (functions.revise_beliefs) {
    engine.revise_beliefs = [revise = functions.revise_beliefs](BeliefRevision& change) {
      Revision revision(change);
      revise(revision);
    };
  }
  if (functions.accepts_message) {
    engine.accepts_message = [accepts = functions.accepts_message](Agent& agent,
                                                                   const Message& message) {
      return accepts(AgentView(agent), {.sender = message.sender,
                                        .performative = agent.symbols().text(message.performative),
                                        .content = message.content});
    };
  }
  const bool is_set = engine.select_event || engine.select_option || engine.select_intention ||
                      engine.revise_beliefs || engine.accepts_message;
  return is_set ? std::make_shared<const Customisation>(std::move(engine)) : nullptr;
}

}  // namespace jaywalk
