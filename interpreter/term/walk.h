#pragma once

// Limits for walks through terms. Terms share parts and may contain themselves (X = f(X) is no
// failure, as in Jason), so a walk may be endless, or exponentially longer than the term is large.

#include <cstdint>

#include "interpreter/term/heap.h"

namespace jaywalk {

/// How many parts one walk may visit: more than fit into the usual heap if nothing is shared.
inline constexpr std::uint64_t kMaxTermParts = 50'000'000;

/// One walk through a term, or through two terms side by side.
class TermWalk {
 public:
  /// Stands for one level of nesting.
  class Level {
   public:
    explicit Level(TermWalk& walk) : walk_(walk) {
      if (walk_.depth_ >= kMaxTermDepth) throw TermTooDeep{};
      ++walk_.depth_;
      walk_.visit();
    }
    ~Level() {
      if (--walk_.depth_ == 0) walk_.parts_ = 0;
    }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    TermWalk& walk_;
  };

  void visit() {
    if (++parts_ > kMaxTermParts) throw HeapExhausted{};
  }
  [[nodiscard]] int depth() const { return depth_; }

 private:
  int depth_ = 0;
  std::uint64_t parts_ = 0;
};

/// Notices that the walk along a list has come back to where it was (Brent 1980): a list that ends
/// in itself, as X = [a|X] makes it.
class ListWalk {
 public:
  void visit(Value pair) {
    if (pair.same_as(remembered_)) throw TermTooDeep{};
    if (--left_ > 0) return;
    remembered_ = pair;
    interval_ *= 2;
    left_ = interval_;
  }

 private:
  Value remembered_;
  std::uint64_t interval_ = 16;
  std::uint64_t left_ = 16;
};

}  // namespace jaywalk
