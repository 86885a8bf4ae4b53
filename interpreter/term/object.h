#pragma once

// Mutable collections that terms refer to: sets, maps and queues. They are shared by reference and
// live as long as a reachable term names them.

#include <functional>

#include "interpreter/term/value.h"

namespace jaywalk {

class Object {
 public:
  enum class Kind { set, map, queue };

  virtual ~Object() = default;
  [[nodiscard]] virtual Kind kind() const = 0;
  /// Passes every Value that it holds to `visit`, which may move it.
  virtual void visit(const std::function<void(Value&)>& visit) = 0;

  /// Set by the collector.
  bool reached = false;
};

}  // namespace jaywalk
