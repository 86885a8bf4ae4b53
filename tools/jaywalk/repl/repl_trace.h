#pragma once

// The lines of `:trace`, one for each step of an agent's reasoning, and how Ctrl-C ends a query.

#include <functional>
#include <string>
#include <string_view>

#include "interpreter/agent/surroundings/observer.h"
#include "tools/jaywalk/console/interrupt.h"

namespace jaywalk {

class ReplTrace : public ReasoningObserver {
 public:
  /// Lines go to `show` while a trace is on.
  explicit ReplTrace(std::function<void(std::string_view line)> show) : show_(std::move(show)) {}

  void set_on(bool on) { on_ = on; }
  /// Null: there is none at the moment.
  void heed(const InterruptGuard* interrupt) { interrupt_ = interrupt; }

  [[nodiscard]] bool interrupted() override {
    return interrupt_ != nullptr && interrupt_->interrupted();
  }
  void event_selected(Agent& agent, const Event& event) override;
  void plan_tried(Agent& agent, const Plan& plan, bool applicable) override;
  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override;
  void no_plan(Agent& agent, const Event& event, bool had_candidates) override;
  void formula_executes(Agent& agent, const Intention& intention, const Step& step) override;
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override;

 private:
  void tell(const std::string& line) { show_(line); }

  std::function<void(std::string_view)> show_;
  const InterruptGuard* interrupt_ = nullptr;
  bool on_ = false;
};

}  // namespace jaywalk
