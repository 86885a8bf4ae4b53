// SPDX-License-Identifier: Apache-2.0
#pragma once

// Output of the lines of `--trace FILE.jsonl`.

#include <cstdint>
#include <cstdio>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "experiment/scenario/files/temporary.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

/// Writes the lines of many tests to one file, in the order of the tests, whatever thread they ran
/// on. The file gets its name only once it is complete.
class TraceFile {
 public:
  /// failure() says whether it can be written.
  explicit TraceFile(std::string path);
  ~TraceFile();
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  /// The lines of the test of that number, or of the next part of a run; every number from 0 once.
  /// From any thread.
  void add(std::uint64_t number, std::string lines);
  /// Empty if all went well so far.
  [[nodiscard]] std::string failure() const { return failure_; }
  /// Gives the file its name, with the lines so far. Returns why that failed; empty if it did not.
  [[nodiscard]] std::string finish();

 private:
  void write(std::string_view lines);

  std::string path_;
  /// Empty if the named file is written to directly.
  std::optional<PartFile> part_;
  std::FILE* file_ = nullptr;
  std::string failure_;
  std::mutex mutex_;
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::string> waiting_;
};

inline constexpr OptionSpec kTraceOption{
    option::kTrace, "FILE.jsonl",
    "write what happens, a JSON object a line: test, tick, percept,\n"
    "event, message, plan, action with its outcome, failure, end",
    Written::file};

/// Opens the file that --trace names, if it does; false, after reporting why, if it cannot be
/// written.
[[nodiscard]] bool open_trace(const Arguments& arguments, std::optional<TraceFile>& trace,
                              Console& console);
/// Ends it; false, after reporting it, if it could not be written.
[[nodiscard]] bool finish_trace(const Arguments& arguments, std::optional<TraceFile>& trace,
                                Console& console);

}  // namespace jaywalk
