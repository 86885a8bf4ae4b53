// SPDX-License-Identifier: Apache-2.0
#pragma once

// Looks at agents as they reason. Derive from Observer, override what is of interest, and give it
// to the run: `Interpreter interpreter({.observer = mine.reasoning()})`. A run without one pays
// nothing.
//
// The functions are called between the steps of the reasoning cycle, on the thread that runs the
// system; an observed system has one thread. They must not call the interpreter. Values are good
// until they return.

#include <memory>
#include <string>

#include <jaywalk/agent_class.h>

namespace jaywalk {

class ReasoningObserver;

class Observer {
 public:
  Observer();
  virtual ~Observer();
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

  /// A belief came or went, a goal was posted; told before it is known whether a plan is for it.
  virtual void event_posted(AgentView /*agent*/, const EventView& /*event*/) {}
  /// Rule SelEv: an event was selected, and a plan is looked for.
  virtual void event_selected(AgentView /*agent*/, const EventView& /*event*/) {}
  /// Rule ApplPl: the context of a relevant plan held, or did not. `plan` names it as messages do,
  /// "plan @p1 at x.asl:3".
  virtual void plan_tried(AgentView /*agent*/, const std::string& /*plan*/,
                          bool /*is_applicable*/) {}
  /// Rules SelAppl and AddIM: a plan was chosen for the event.
  virtual void plan_chosen(AgentView /*agent*/, const EventView& /*event*/,
                           const std::string& /*plan*/, const IntentionView& /*intention*/) {}
  /// No plan was chosen for the event.
  virtual void no_plan(AgentView /*agent*/, const EventView& /*event*/) {}
  /// Rule ExecInt: a formula is executed; its text has the values that its variables have by now.
  virtual void formula_executes(AgentView /*agent*/, const IntentionView& /*intention*/,
                                const std::string& /*formula*/) {}
  /// The intention's formula has failed: error(id), error_msg(message).
  virtual void formula_failed(AgentView /*agent*/, const IntentionView& /*intention*/,
                              const std::string& /*id*/, const std::string& /*message*/) {}

  /// For MasOptions::observer; lives as long as this.
  [[nodiscard]] ReasoningObserver* reasoning();

 private:
  class Adapter;
  std::unique_ptr<Adapter> adapter_;
};

}  // namespace jaywalk
