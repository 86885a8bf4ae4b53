// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/workers.h"

#include <system_error>
#include <utility>

namespace jaywalk {
namespace {

// How often a thread looks for work, or for the end of the others' work, before it goes to sleep.
constexpr int kLooks = 500;

// Waits until the value is no longer what it was.
template <class T>
void wait_for_change(const std::atomic<T>& value, T old) {
  for (int look = 0; look < kLooks; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Workers::Workers(std::size_t count) {
  threads_.reserve(count);
  for (std::size_t worker = 1; worker < count; ++worker) {
    try {
      threads_.emplace_back([this, worker] { wait_for_work(worker); });
    } catch (const std::system_error&) {
      break;  // no more threads can be started; results do not depend on their number
    }
  }
}

Workers::~Workers() {
  is_over_ = true;
  ++call_;
  call_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::run(std::size_t blocks, const Work& work) {
  work_ = &work;
  blocks_ = blocks;
  next_block_ = 0;
  busy_ = threads_.size();
  ++call_;
  call_.notify_all();
  take_blocks(0);
  for (std::size_t busy = busy_; busy > 0; busy = busy_) wait_for_change(busy_, busy);
  if (problem_) std::rethrow_exception(std::exchange(problem_, nullptr));
}

void Workers::wait_for_work(std::size_t worker) {
  for (std::uint32_t seen = 0;; ++seen) {
    wait_for_change(call_, seen);
    if (is_over_) return;
    take_blocks(worker);
    if (--busy_ == 0) busy_.notify_one();
  }
}

void Workers::take_blocks(std::size_t worker) {
  for (std::size_t block = next_block_++; block < blocks_; block = next_block_++) {
    try {
      (*work_)(worker, block);
    } catch (...) {
      const std::lock_guard guard(problem_mutex_);
      if (!problem_) problem_ = std::current_exception();
    }
  }
}

}  // namespace jaywalk
