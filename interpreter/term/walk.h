// SPDX-License-Identifier: Apache-2.0
#pragma once

// Limits for walks through terms. Terms share parts and may contain themselves (X = f(X) is no
// failure, as in Jason), so a walk may be endless, or exponentially longer than the term is large.

#include <cstdint>
#include <unordered_map>

#include "interpreter/term/heap.h"
#include "interpreter/term/value.h"

namespace jaywalk {

/// How many parts one walk may visit: more than fit into the usual heap if nothing is shared.
inline constexpr std::uint64_t kMaxTermParts = 50'000'000;

/// One walk through a term, or through two terms side by side.
class TermWalk {
 public:
  /// Stands for one level of nesting: `term`'s, if it is given, which no level below can have but
  /// that of a term that contains itself.
  class Level {
   public:
    explicit Level(TermWalk& walk, Value term = {}) : walk_(walk) {
      if (walk_.depth_ >= kShallow) walk_.look_for_circle(term);
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
  /// Down to here no walk asks whether it goes round in a circle.
  static constexpr int kShallow = 64;

 private:
  // Goes down to kMaxTermDepth only if it has to: the way back takes an exception through all
  // levels, which is slow. Remembers the term of a level, and of one that is twice as deep, and so
  // on (Brent 1980), until the walk has come back above that level.
  void look_for_circle(Value term) {
    if (depth_ >= kMaxTermDepth) throw TermTooDeep{};
    if (depth_ <= level_remembered_) level_remembered_ = 0;
    const bool is_given = !term.is_unset();
    if (level_remembered_ != 0 && is_given && term.same_as(remembered_)) throw TermTooDeep{};
    if (is_given && (level_remembered_ == 0 || depth_ >= 2 * level_remembered_)) {
      remembered_ = term;
      level_remembered_ = depth_;
    }
  }

  int depth_ = 0;
  int level_remembered_ = 0;
  Value remembered_;
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

/// Terms that contain themselves: X = f(X) binds X to a term in which X stands. The lists and
/// structures below a term that contain themselves, by Value::bits(), each with a variable whose
/// value it is. Every way down that does not end comes to one of them.
using Circles = std::unordered_map<std::uint64_t, const Variable*>;

/// REQUIRES: `slots` are those of the term's template, or it has none.
[[nodiscard]] Circles circles_of(Value term, const Value* slots = nullptr);

}  // namespace jaywalk
