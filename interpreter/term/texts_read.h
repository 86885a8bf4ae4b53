// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texts that become names while agents reason. A name is never forgotten: how much all of them take
// counts for all agents together, but only once a round is over (mas/memory.cpp), since who makes a
// name first depends on threads. Up to then an agent may only read as much as it has room for.

#include <cstddef>

#include "interpreter/term/heap.h"

namespace jaywalk {

class TextsRead {
 public:
  /// An agent begins a turn; `left_of_all` is the remainder of the memory of all.
  void begin_turn(std::size_t left_of_all) {
    bytes_ = 0;
    left_of_all_ = left_of_all;
  }

  /// Call this before a text of `bytes` bytes is read. Throws HeapExhausted if the texts read in
  /// this turn could take more than the remainder, of all or of the heap's owner: names remain when
  /// the terms of an agent that owns little are gone.
  void require_room(Heap& heap, std::size_t bytes) {
    // A name of one letter takes that many: its texts, entries of tables, and before all that the
    // syntax tree.
    constexpr std::size_t kTakenByEach = 32;
    bytes_ += kTakenByEach * bytes;
    if (bytes_ > left_of_all_) throw HeapExhausted{true};
    heap.require_bytes(bytes_);
  }

 private:
  std::size_t bytes_ = 0;
  std::size_t left_of_all_ = std::size_t(-1);
};

}  // namespace jaywalk
