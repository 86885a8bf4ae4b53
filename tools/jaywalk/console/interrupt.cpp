// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/interrupt.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stop_token>
#include <utility>

#include "env/process/guarded_child.h"
#include "tools/jaywalk/console/console.h"

namespace jaywalk {
namespace {

extern "C" void note_interrupt(int signal) {
  end_requested = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  end_requested = false;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Handler before = std::signal(signal, note_interrupt);
    if (signal == SIGHUP && before == SIG_IGN) {
      std::signal(signal, SIG_IGN);
    } else {
      noted_.push_back({signal, before});
    }
  }
}

InterruptGuard::~InterruptGuard() {
  for (const Noted& each : noted_) std::signal(each.signal, each.before);
}

bool InterruptGuard::interrupted() const { return end_requested; }

PromptEnd::PromptEnd(const InterruptGuard& interrupt, std::function<void()> clean) {
  watcher_ = std::jthread([this, &interrupt, clean = std::move(clean)](std::stop_token stopped) {
    constexpr std::chrono::milliseconds kBetweenLooks{50};
    std::unique_lock lock(mutex_);
    while (!interrupt.interrupted()) {
      const bool over =
          ended_.wait_for(lock, stopped, kBetweenLooks, [&] { return stopped.stop_requested(); });
      if (over) return;
    }
    if (clean) clean();
    std::fputs("interrupted\n", stderr);
    std::_Exit(static_cast<int>(ExitCode::interrupted));
  });
}

PromptEnd::~PromptEnd() {
  watcher_.request_stop();
  ended_.notify_all();
}

Deadline::Deadline(std::optional<double> seconds) {
  // More than a century is no limit, and would overflow the clock.
  constexpr double kLongest = 3e9;
  if (!seconds || *seconds > kLongest) return;
  seconds_ = *seconds;
  at_ = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                               std::chrono::duration<double>(seconds_));
  watcher_ = std::jthread([this](std::stop_token stopped) { watch(std::move(stopped)); });
}

Deadline::~Deadline() {
  watcher_.request_stop();
  ended_.notify_all();
}

bool Deadline::passed() const { return at_ && std::chrono::steady_clock::now() >= *at_; }

void Deadline::watch(std::stop_token stopped) {
  std::unique_lock lock(mutex_);
  if (ended_.wait_until(lock, stopped, *at_ + kGrace, [&] { return stopped.stop_requested(); })) {
    return;
  }
  std::fflush(stdout);
  std::fprintf(stderr, "error: stopped after %g s (--timeout)\n", seconds_);
  std::_Exit(EXIT_FAILURE);
}

}  // namespace jaywalk
