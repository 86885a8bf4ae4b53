#pragma once

// Timers, ordered by time and, at the same time, by when they were requested.

#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

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

}  // namespace jaywalk
