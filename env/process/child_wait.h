#pragma once

// Waiting for a child process, no longer than until the program is asked to end.

#include <atomic>
#include <chrono>
#include <poll.h>
#include <span>
#include <string>
#include <string_view>

namespace jaywalk {

/// The program is asked to end (Ctrl-C, SIGTERM, SIGHUP): whoever waits for a child gives up. A
/// signal handler sets it, which can reach nothing but a global. A program that leaves it false,
/// because it embeds this library, waits as long as the limits say.
inline std::atomic<bool> end_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// What wait_for_child() says if nobody waits any longer: the program is to end, or it is too late.
inline constexpr std::string_view kInterrupted = "interrupted";
inline constexpr std::string_view kLate = "late";

/// Until poll() finds one of the descriptors ready, the deadline has passed or the program is asked
/// to end, which is noticed within 50 ms. Why none is ready; empty if one is.
[[nodiscard]] std::string wait_for_child(std::span<pollfd> descriptors,
                                         std::chrono::steady_clock::time_point deadline);

}  // namespace jaywalk
