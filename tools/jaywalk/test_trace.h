#pragma once

// `--trace FILE.jsonl` of run and compare: what happens in tests, a JSON object a line. A line of
// the kind `test` begins one, `end` ends it; between them stand, in the order of time, for each
// tick `percept`, `event`, `message`, `plan`, `failure` and `action`, with the agent, and `tick`.

#include <cstdint>
#include <cstdio>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiment/trial.h"
#include "interpreter/agent/observer.h"
#include "tools/jaywalk/arguments.h"
#include "tools/jaywalk/console.h"

namespace jaywalk {

/// Looks at the agents of one test. An action's line comes when its outcome is known, in the next
/// tick; it says in which tick the agent acted.
class TestTrace final : public ReasoningObserver {
 public:
  void begin(std::string_view behaviour, const TrialInput& input);
  /// As TrialOptions::observe: before the first tick and after each.
  void tick(const Crossing& crossing, const Mas& mas);
  void end(const TrialResult& result);
  /// The lines so far.
  [[nodiscard]] const std::string& lines() const { return lines_; }

  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override;
  void formula_executes(Agent& agent, const Intention& intention, const Step& step) override;
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override;
  void event_posted(Agent& agent, const Event& event) override;

 private:
  struct Action {
    std::string text;
    int tick = 0;
    bool failed = false;
    std::string reason;
  };
  void write(const Action& action, const std::string& agent);

  int tick_ = 1;                           // the one that agents reason in
  std::map<std::string, Action> actions_;  // whose outcome is not known yet, by the agents' names
  std::string lines_;
};

/// The lines of many tests in one file, in the order of the tests whatever thread they ran on. The
/// file stands in its place when it is whole.
class TraceFile {
 public:
  /// failure() says whether it can be written.
  explicit TraceFile(std::string path);
  ~TraceFile();
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  /// The lines of the test of that number; every number from 0 once. From any thread.
  void add(std::uint64_t number, std::string lines);
  /// Empty if all went well so far.
  [[nodiscard]] std::string failure() const { return failure_; }
  /// Puts the file into its place, with what there is. Empty, or why that failed.
  [[nodiscard]] std::string finish();

 private:
  void write(std::string_view lines);

  std::string path_;
  std::string temporary_;
  std::FILE* file_ = nullptr;
  std::string failure_;
  std::mutex mutex_;
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::string> waiting_;
};

inline constexpr OptionSpec kTraceOption{
    "trace", "FILE.jsonl",
    "write what happens, a JSON object a line: test, tick, percept,\n"
    "event, message, plan, action with its outcome, failure, end",
    Written::file};

/// Opens the file that --trace names, if it does; false, after reporting why, if it cannot be
/// written or --coverage is asked for, too: agents have one observer.
[[nodiscard]] bool open_trace(const Arguments& arguments, std::optional<TraceFile>& trace,
                              Console& console);
/// Ends it; false, and said so, if it could not be written.
[[nodiscard]] bool finish_trace(const Arguments& arguments, std::optional<TraceFile>& trace,
                                Console& console);

}  // namespace jaywalk
