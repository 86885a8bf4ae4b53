// SPDX-License-Identifier: Apache-2.0
#pragma once

// SUMO as a process of ours, asked by TraCI, and the one that makes its networks. Both are of the
// Debian package `sumo`. They end with us (env/process/guarded_child.h).

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "env/process/guarded_child.h"
#include "env/simulator/sumo/traci_client.h"

namespace jaywalk {

/// A file without a name, in memory, which SUMO reads and writes. It disappears with our process.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// A path by which our child processes can open it.
  [[nodiscard]] std::string path() const;
  /// Replaces the content; false if there is not enough memory.
  [[nodiscard]] bool write(std::string_view text);
  /// The content, at most the last `most` bytes.
  [[nodiscard]] std::string read(std::size_t most) const;

 private:
  int descriptor_;
};

class SumoProcess {
 public:
  SumoProcess() = default;
  ~SumoProcess() { end(); }
  SumoProcess(const SumoProcess&) = delete;
  SumoProcess& operator=(const SumoProcess&) = delete;

  [[nodiscard]] bool is_running() const { return child_.guard >= 0 && client_.is_connected(); }
  /// Starts it with options of its command line. `token` is a vehicle type of its routes, by which
  /// our SUMO is distinguished from another program's at the same port. Why that failed, if it did.
  [[nodiscard]] std::string start(const std::vector<std::string>& options,
                                  const std::string& token);
  /// As TraciClient::ask. After any error the process is ended, and how it ended is part of the
  /// error if that says more. REQUIRES: it is running.
  [[nodiscard]] TraciAnswer ask(const TraciMessage& message);
  [[nodiscard]] std::vector<TraciAnswer> ask(std::span<const TraciMessage> messages);
  void end();
  /// `SUMO 1.15.0`.
  [[nodiscard]] const std::string& version() const { return version_; }

 private:
  [[nodiscard]] std::string try_port(const std::vector<std::string>& options,
                                     const std::string& token, bool& again);
  [[nodiscard]] bool connect_within(int port, std::chrono::milliseconds limit);
  [[nodiscard]] std::string with_last_words(std::string what);

  GuardedChild child_;
  TraciClient client_;
  MemoryFile errors_;
  std::string version_;
};

/// Runs a program of the package to its end. What went wrong, if it did; else `output` holds what
/// it printed, if that is asked for.
[[nodiscard]] std::string run_sumo_tool(const std::vector<std::string>& command,
                                        std::string* output = nullptr);

/// The version of the SUMO that is installed, `1.15.0`. What went wrong, if it did.
[[nodiscard]] std::string sumo_version(std::string& version);

}  // namespace jaywalk
