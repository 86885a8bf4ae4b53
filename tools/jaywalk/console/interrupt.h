// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ctrl-C and the wall clock: what ends a run from outside.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace jaywalk {

/// While one exists, the first Ctrl-C, SIGTERM or SIGHUP is noted instead of ending the program; a
/// second one ends it. A SIGHUP that the program was started to ignore (nohup) stays ignored.
/// The destructor restores the former handlers.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;

 private:
  using Handler = void (*)(int);

  struct Noted {
    int signal;
    Handler before;
  };
  std::vector<Noted> noted_;
};

/// For long work that does not poll for interrupts (a page of a large store, say): while one
/// exists, the program ends at once when the first of those signals comes, with exit code 130. A
/// file that is being written then has no name yet.
class PromptEnd {
 public:
  /// `clean` is called before the program ends; it removes unfinished files.
  explicit PromptEnd(const InterruptGuard& interrupt, std::function<void()> clean = nullptr);
  ~PromptEnd();
  PromptEnd(const PromptEnd&) = delete;
  PromptEnd& operator=(const PromptEnd&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread watcher_;
};

/// The time that a run may take. What does not look at it in time (a query that goes on for very
/// long) is ended all the same, kGrace later: the program then exits with code 1.
class Deadline {
 public:
  static constexpr std::chrono::milliseconds kGrace{500};

  /// No time limit if there are no seconds.
  explicit Deadline(std::optional<double> seconds);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  [[nodiscard]] bool passed() const;
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  void watch(std::stop_token stopped);

  double seconds_ = 0;
  std::optional<std::chrono::steady_clock::time_point> at_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread watcher_;
};

}  // namespace jaywalk
