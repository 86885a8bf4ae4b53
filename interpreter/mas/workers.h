// SPDX-License-Identifier: Apache-2.0
#pragma once

// Threads that work through a number of blocks together. They wait between two calls, at first
// awake, since the next call mostly comes within microseconds, then asleep.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace jaywalk {

class Workers {
 public:
  /// `work(worker, block)`; workers are counted from 0, which is the thread that calls run().
  using Work = std::function<void(std::size_t worker, std::size_t block)>;

  /// REQUIRES: at least one.
  explicit Workers(std::size_t count);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] std::size_t count() const { return threads_.size() + 1; }
  /// Does the work for the blocks 0 to `blocks` - 1, each once, on whichever worker is free; they
  /// are begun in this order. Returns when all are done, with the exception of one that threw.
  void run(std::size_t blocks, const Work& work);

 private:
  void wait_for_work(std::size_t worker);
  void take_blocks(std::size_t worker);

  std::vector<std::thread> threads_;
  const Work* work_ = nullptr;
  std::size_t blocks_ = 0;
  std::atomic<std::size_t> next_block_ = 0;
  std::atomic<std::uint32_t> call_ = 0;  // counts the calls of run()
  std::atomic<std::size_t> busy_ = 0;    // threads that have not finished with this call
  std::atomic<bool> is_over_ = false;
  std::mutex problem_mutex_;
  std::exception_ptr problem_;
};

}  // namespace jaywalk
