// SPDX-License-Identifier: Apache-2.0
#pragma once

// Random terms and programs as text, for property tests and fuzzing. The same seed gives the same
// texts on every machine.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk::test {

/// A source of choices (SplitMix64).
class Choices {
 public:
  explicit Choices(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next();
  /// 0 ... count-1. REQUIRES: count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  /// True once in `times` times.
  bool once_in(std::size_t times) { return below(times) == 0; }
  std::string_view one_of(std::initializer_list<std::string_view> texts) {
    return texts.begin()[below(texts.size())];
  }

 private:
  std::uint64_t state_;
};

struct TermKinds {
  bool variables = true;
  bool annotations = true;
  bool expressions = false;
  int depth = 4;
};

/// A term over few names, so that two of them often have something in common.
[[nodiscard]] std::string random_term(Choices& choices, const TermKinds& kinds);

/// A well-formed program that uses most of the language, without internal actions that reach
/// beyond the agent. Names are few, so that its parts meet.
[[nodiscard]] std::string random_program(Choices& choices);

/// The text with some of its bytes or tokens changed, doubled, swapped or taken from `other`.
[[nodiscard]] std::string mutate(Choices& choices, std::string text, std::string_view other);

}  // namespace jaywalk::test
