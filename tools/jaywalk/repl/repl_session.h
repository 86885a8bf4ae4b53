// SPDX-License-Identifier: Apache-2.0
#pragma once

// A conversation with one agent: each input is carried out, then the agent reasons until it has
// nothing more to do.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/syntax/load.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/repl/repl_input.h"
#include <jaywalk/interpreter.h>

namespace jaywalk {

/// The lines of `:trace`, one for each step of an agent's reasoning, and how Ctrl-C ends a query.
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

class LineReader;

class ReplSession {
 public:
  /// `pauses` reads a line after each step of a trace; null: traces do not wait.
  ReplSession(IncludePath include_path, Console& console, LineReader* pauses);

  /// Begins anew with the program of a file, or with none if `path` is empty. False: it is wrong,
  /// and what there was stays.
  bool load(const std::string& path);
  /// False: the conversation is over.
  bool carry_out(const ReplInput& input);
  /// The names for completion.
  [[nodiscard]] ReplNames names() const;
  /// Whether some input was wrong.
  [[nodiscard]] bool had_mistakes() const { return had_mistakes_; }

 private:
  bool carry_out_command(const ReplInput& input);
  void ask(const std::string& query);
  /// A name that is like that of the goal or query, if nothing has its own.
  void suggest(const std::string& text, bool is_goal);
  void trace(const std::string& goal);
  void show_beliefs(const std::string& name);
  void show_rules_and_plans(const std::string& name, bool rules);
  void show_intentions();
  void reason();
  /// Reports diagnostics; true if there are none.
  bool accept(const Diagnostics& found);
  void mistake(std::string_view message, std::string_view hint = {});
  void print_line(std::string_view line);

  IncludePath include_path_;
  Console& console_;
  LineReader* pauses_;
  ReplTrace trace_;
  bool waits_ = false;  // a trace waits after each step
  std::string path_;
  std::unique_ptr<Interpreter> interpreter_;
  AgentId agent_{};
  bool had_mistakes_ = false;
};

}  // namespace jaywalk
