// SPDX-License-Identifier: Apache-2.0
#pragma once

// A child process that ends with us, however we end: even after SIGKILL. Between us and the program
// stands a guard, a small process that leads a group of its own and waits for two things: that the
// program ends, which it repeats to us as its own end, or that we do, and then it kills the group.
// (PR_SET_PDEATHSIG alone follows the thread that started the child, and forgets grandchildren.)

#include <atomic>
#include <chrono>
#include <poll.h>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace jaywalk {

/// The program is asked to end (Ctrl-C, SIGTERM, SIGHUP): all waits for a child end. It is global
/// because a signal handler sets it. A host program that embeds this library may leave it false;
/// waits then end at their limits alone.
inline std::atomic<bool> end_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// Results of wait_for_child(): the program was asked to end, or the deadline has passed.
inline constexpr std::string_view kInterrupted = "interrupted";
inline constexpr std::string_view kLate = "late";

/// Until poll() finds one of the descriptors ready, the deadline has passed or the program is asked
/// to end, which is noticed within 50 ms. Why none is ready; empty if one is.
[[nodiscard]] std::string wait_for_child(std::span<pollfd> descriptors,
                                         std::chrono::steady_clock::time_point deadline);

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

/// Waits for the program to end by itself, unless we are asked to end, then kills
/// the remaining processes of its group. Returns the status of waitpid, -1 if it had to be killed,
/// and resets `child`. REQUIRES: the child was started.
int end_guarded(GuardedChild& child, std::chrono::milliseconds patience);

}  // namespace jaywalk
