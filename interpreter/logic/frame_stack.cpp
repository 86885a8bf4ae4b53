// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/frame_stack.h"

#include <algorithm>
#include <functional>

namespace jaywalk {

void FrameStack::enter_chunk(std::size_t index) {
  chunk_ = index;
  begin_ = top_ = chunks_[index].words.get();
  end_ = begin_ + chunks_[index].size;
}

// The rest of a chunk stays unused if the frame does not fit.
void FrameStack::next_chunk(std::size_t words) {
  std::size_t index = begin_ == nullptr ? 0 : chunk_ + 1;
  while (index < chunks_.size() && chunks_[index].size < words) ++index;
  if (index == chunks_.size()) {
    const std::size_t size = std::max(words, chunks_.empty() ? kChunkWords / 16 : kChunkWords);
    chunks_.push_back({std::make_unique_for_overwrite<std::uint64_t[]>(size), size});
  }
  enter_chunk(index);
}

// Makes the chunk current that a mark lies in: this one or an earlier one.
void FrameStack::find_chunk(Mark mark) {
  if (chunks_.empty()) return;
  std::size_t index = mark == nullptr ? 0 : chunk_;
  const auto is_in = [&](const Chunk& chunk) {
    return !std::less<>{}(mark, chunk.words.get()) &&
           !std::less<>{}(chunk.words.get() + chunk.size, mark);
  };
  while (index > 0 && !is_in(chunks_[index])) --index;
  enter_chunk(index);
}

bool FrameStack::contains(const void* address) const {
  const auto* const word = static_cast<const std::uint64_t*>(address);
  return std::any_of(chunks_.begin(), chunks_.end(), [word](const Chunk& chunk) {
    return !std::less<>{}(word, chunk.words.get()) &&
           std::less<>{}(word, chunk.words.get() + chunk.size);
  });
}

}  // namespace jaywalk
