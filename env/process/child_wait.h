#pragma once

// Waiting for a child process, no longer than until the program is asked to end.

#include <atomic>
#include <chrono>
#include <poll.h>
#include <span>
#include <string>
#include <string_view>

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

}  // namespace jaywalk
