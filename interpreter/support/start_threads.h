// SPDX-License-Identifier: Apache-2.0
#pragma once

// Threads that share some work, as many as can be had.

#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace jaywalk {

/// Starts threads that call `work`, up to `count` in all, and returns their number. Fewer are
/// started where the system has no more. Throws std::system_error if it has none at all.
template <class Thread, class Work>
std::size_t start_threads(std::vector<Thread>& threads, std::size_t count, Work work) {
  threads.reserve(count);
  while (threads.size() < count) {
    try {
      threads.emplace_back(work);
    } catch (const std::system_error&) {
      if (threads.empty()) throw;
      break;
    }
  }
  return threads.size();
}

}  // namespace jaywalk
