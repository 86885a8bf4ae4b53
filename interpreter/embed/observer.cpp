// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/surroundings/observer.h"

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/embed/agent_functions.h"
#include <jaywalk/observer.h>

namespace jaywalk {

class Observer::Adapter final : public ReasoningObserver {
 public:
  explicit Adapter(Observer& own) : own_(own) {}

  void event_posted(Agent& agent, const Event& event) override {
    own_.event_posted(AgentView(agent), view_of(event));
  }
  void event_selected(Agent& agent, const Event& event) override {
    own_.event_selected(AgentView(agent), view_of(event));
  }
  void plan_tried(Agent& agent, const Plan& plan, bool applicable) override {
    own_.plan_tried(AgentView(agent), agent.plan_name(plan), applicable);
  }
  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override {
    // The intention gets the plan after this.
    own_.plan_chosen(AgentView(agent), view_of(event), agent.plan_name(plan),
                     {.number = intention.id, .label = plan.label});
  }
  void no_plan(Agent& agent, const Event& event, bool /*had_candidates*/) override {
    own_.no_plan(AgentView(agent), view_of(event));
  }
  void formula_executes(Agent& agent, const Intention& intention, const Step& step) override {
    own_.formula_executes(AgentView(agent), view_of(intention),
                          formula_with_values(agent, intention, step));
  }
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override {
    own_.formula_failed(AgentView(agent), view_of(intention), error.id, error.message);
  }

 private:
  Observer& own_;
};

Observer::Observer() : adapter_(std::make_unique<Adapter>(*this)) {}
Observer::~Observer() = default;
ReasoningObserver* Observer::reasoning() { return adapter_.get(); }

}  // namespace jaywalk
