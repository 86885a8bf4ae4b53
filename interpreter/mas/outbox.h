// SPDX-License-Identifier: Apache-2.0
#pragma once

// Requests to the system from agents that reason in parallel: lines to write, messages, timers, the
// end of the run. They are carried out afterwards, in the order in which the agents would have made
// them one after another.

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include "interpreter/agent/circumstance/circumstance.h"
#include "interpreter/mas/mas.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

struct Timer {
  enum class Purpose : std::uint8_t { agent, departure, stop };

  double at_ms = 0;
  std::uint64_t sequence = 0;
  Purpose purpose = Purpose::agent;
  std::uint32_t agent = 0;
  std::uint64_t token = 0;

  bool operator>(const Timer& other) const {
    return std::tie(at_ms, sequence) > std::tie(other.at_ms, other.sequence);
  }
};

/// Ordered by time and, at the same time, by when they were requested.
class Timers {
 public:
  void add(Timer timer) {
    timer.sequence = ++sequence_;
    queue_.push(timer);
  }
  [[nodiscard]] bool empty() const { return queue_.empty(); }
  /// REQUIRES: not empty; so do the others.
  [[nodiscard]] const Timer& next() const { return queue_.top(); }
  [[nodiscard]] double next_ms() const { return queue_.top().at_ms; }
  Timer take() {
    const Timer timer = queue_.top();
    queue_.pop();
    return timer;
  }

 private:
  std::priority_queue<Timer, std::vector<Timer>, std::greater<>> queue_;
  std::uint64_t sequence_ = 0;
};

class Outbox {
 public:
  enum class Kind : std::uint8_t { print, write, log, letter, timer };
  struct Letter {
    std::uint32_t receiver = 0;
    /// Its content is in `heap`.
    Message message;
  };
  struct End {
    RunEnd how = RunEnd::stopped;
    std::string message;
    int exit_code = 0;
    RunLimit limit = RunLimit::none;
    std::string agent;
    std::string where;
  };

  void add_text(Kind kind, std::string text) {
    order_.push_back(kind);
    text_bytes_ += sizeof(std::string) + text.size();
    texts_.push_back(std::move(text));
  }
  void add(Letter letter) {
    order_.push_back(Kind::letter);
    letters_.push_back(std::move(letter));
  }
  void add(const Timer& timer) {
    order_.push_back(Kind::timer);
    timers_.push_back(timer);
  }
  /// Its size, without the overhead of the letters' contents beside their terms.
  [[nodiscard]] std::size_t bytes() const {
    return text_bytes_ + heap.bytes() + letters_.size() * sizeof(Letter) +
           timers_.size() * sizeof(Timer);
  }
  /// Hands everything over, in order: text(kind, text), letter(letter), timer(timer).
  template <class OnText, class OnLetter, class OnTimer>
  void empty(OnText text, OnLetter letter, OnTimer timer);

  /// For the contents of letters.
  Heap heap;
  /// Cycles and turns that agents have taken.
  std::uint64_t cycles = 0;
  std::uint64_t turns = 0;
  /// By how much more, or less, agents own.
  std::int64_t grown = 0;
  /// Somebody has ended the run; no agent reasons after that.
  std::optional<End> end;

 private:
  std::size_t text_bytes_ = 0;
  std::vector<Kind> order_;
  std::vector<std::string> texts_;
  std::vector<Letter> letters_;
  std::vector<Timer> timers_;
};

template <class OnText, class OnLetter, class OnTimer>
void Outbox::empty(OnText text, OnLetter letter, OnTimer timer) {
  std::size_t texts = 0;
  std::size_t letters = 0;
  std::size_t timers = 0;
  for (const Kind kind : order_) {
    switch (kind) {
      case Kind::letter:
        letter(letters_[letters++]);
        break;
      case Kind::timer:
        timer(timers_[timers++]);
        break;
      case Kind::print:
      case Kind::write:
      case Kind::log:
        text(kind, texts_[texts++]);
        break;
    }
  }
}

}  // namespace jaywalk
