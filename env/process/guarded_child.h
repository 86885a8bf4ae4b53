#pragma once

// A child process that ends with us, however we end: even after SIGKILL. Between us and the program
// stands a guard, a small process that leads a group of its own and waits for two things: that the
// program ends, which it repeats to us as its own end, or that we do, and then it kills the group.
// (PR_SET_PDEATHSIG alone follows the thread that started the child, and forgets grandchildren.)

#include <chrono>
#include <string>
#include <sys/types.h>
#include <vector>

namespace jaywalk {

struct GuardedChild {
  /// The guard; its group is that of the program and all that it starts. -1: none.
  pid_t guard = -1;
  /// Open as long as we live.
  int lifeline = -1;
};

/// How the program is connected.
struct ChildStreams {
  /// Its standard input and output.
  int channel = -1;
  /// Its standard error; -1: ours.
  int errors = -1;
};

/// Starts a program, found as the shell does, with its arguments, in a folder (empty: the current
/// one). Why that failed, if it did.
[[nodiscard]] std::string start_guarded(const std::vector<std::string>& command,
                                        const std::string& folder, ChildStreams streams,
                                        GuardedChild& child);

/// Waits for the program to end by itself, unless we are asked to end (child_wait.h), then kills
/// the remaining processes of its group. Returns the status of waitpid, -1 if it had to be killed,
/// and resets `child`. REQUIRES: the child was started.
int end_guarded(GuardedChild& child, std::chrono::milliseconds patience);

}  // namespace jaywalk
