#pragma once

// A value that is made when first needed, and then kept.

#include <functional>
#include <optional>
#include <utility>

namespace jaywalk {

/// REQUIRES: one thread at a time asks.
template <class T>
class Lazy {
 public:
  explicit Lazy(std::function<T()> make) : make_(std::move(make)) {}

  [[nodiscard]] const T& operator*() const {
    if (!value_) value_ = make_();
    return *value_;
  }
  [[nodiscard]] const T* operator->() const { return &**this; }

 private:
  std::function<T()> make_;
  mutable std::optional<T> value_;
};

}  // namespace jaywalk
