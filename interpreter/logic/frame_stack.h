// SPDX-License-Identifier: Apache-2.0
#pragma once

// Memory for the frames of rules: blocks that never move, cut back as a stack.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace jaywalk {

class FrameStack {
 public:
  /// A place to cut back to: the end of the used part, or the begin of a frame. Null: all.
  using Mark = std::uint64_t*;

  [[nodiscard]] bool has_room(std::size_t words) const {
    return static_cast<std::size_t>(end_ - top_) >= words;
  }
  [[nodiscard]] std::uint64_t* allocate(std::size_t words) {
    if (!has_room(words)) next_chunk(words);
    std::uint64_t* const block = top_;
    top_ += words;
    return block;
  }
  [[nodiscard]] Mark mark() const { return top_; }
  void release(Mark mark) {
    const auto offset = reinterpret_cast<std::uintptr_t>(mark) - begin_address();
    if (offset > static_cast<std::size_t>(end_ - begin_) * sizeof(std::uint64_t)) find_chunk(mark);
    top_ = mark == nullptr ? begin_ : mark;
  }
  /// Roughly how much is in use.
  [[nodiscard]] std::size_t words() const {
    return chunk_ * kChunkWords + static_cast<std::size_t>(top_ - begin_);
  }
  [[nodiscard]] bool contains(const void* address) const;

 private:
  static constexpr std::size_t kChunkWords = 4096;
  struct Chunk {
    std::unique_ptr<std::uint64_t[]> words;
    std::size_t size = 0;
  };
  [[nodiscard]] std::uintptr_t begin_address() const {
    return reinterpret_cast<std::uintptr_t>(begin_);
  }
  void next_chunk(std::size_t words);
  void find_chunk(Mark mark);
  void enter_chunk(std::size_t index);

  std::uint64_t* begin_ = nullptr;  // of the current chunk
  std::uint64_t* top_ = nullptr;
  std::uint64_t* end_ = nullptr;
  std::size_t chunk_ = 0;
  std::vector<Chunk> chunks_;
};

}  // namespace jaywalk
