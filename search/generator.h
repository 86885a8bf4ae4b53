// SPDX-License-Identifier: Apache-2.0
#pragma once

// A generator proposes test inputs and learns from their results. Each has a file in generators/
// and a row in generators.def; docs/internals/add_generator.md adds one. Read sut.h first.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "env/number_parameter.h"
#include "search/sut.h"

namespace jaywalk::search {

/// The services available to a generator while it proposes an input; counts every candidate whose
/// validity is checked.
class Asking {
 public:
  Asking(const SearchSpace& space, double spent) : space_(space), spent_(spent) {}

  [[nodiscard]] bool valid(const TestInput& candidate) {
    ++candidates_;
    const bool is_valid = space_.contains(candidate);
    if (!is_valid) ++invalid_;
    return is_valid;
  }
  /// The share of the budget that is spent, 0 to 1.
  [[nodiscard]] double spent() const { return spent_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }
  [[nodiscard]] std::uint64_t invalid() const { return invalid_; }

 private:
  const SearchSpace& space_;
  double spent_;
  std::uint64_t candidates_ = 0;
  std::uint64_t invalid_ = 0;
};

class Generator {
 public:
  Generator() = default;
  Generator(const Generator&) = delete;
  Generator& operator=(const Generator&) = delete;
  virtual ~Generator() = default;

  /// Whether there are no further tests; the search ends then.
  [[nodiscard]] virtual bool exhausted() const { return false; }
  /// The next test; it must be valid. REQUIRES: not exhausted.
  [[nodiscard]] virtual TestInput ask(Asking& asking) = 0;
  /// Receives the result of the latest proposed test; `spent` is the share of the budget.
  virtual void tell(const ExecutedTest& test, double spent) = 0;
};

/// A generator's inputs; everything referred to must outlive it.
struct GeneratorSetup {
  const SearchSpace& space;
  std::span<const MeasureKind> measures;
  Fitness fitness;
  std::uint64_t seed = 0;
  /// In the order of the kind's parameters.
  std::span<const double> values;
};

struct GeneratorKind {
  std::string_view name;
  std::string_view summary;
  std::span<const NumberParameter> parameters;
  std::function<std::unique_ptr<Generator>(const GeneratorSetup& setup)> make;
};

[[nodiscard]] std::span<const GeneratorKind> generators();
/// Null if there is none of that name.
[[nodiscard]] const GeneratorKind* find_generator(std::string_view name);

/// How many candidates draw_valid() looks at: for the first test of a search, where it may be that
/// none is valid, and later.
inline constexpr int kFirstDraws = 10'000;
inline constexpr int kMostDraws = 100'000;

/// A valid input from `draw`; gives up after very many and returns an invalid one, which the search
/// refuses with a message.
template <class Draw>
[[nodiscard]] TestInput draw_valid(Asking& asking, Draw draw) {
  const int most = asking.spent() > 0 ? kMostDraws : kFirstDraws;
  TestInput input;
  for (int i = 0; i < most; ++i) {
    input = draw();
    if (asking.valid(input)) break;
  }
  return input;
}

}  // namespace jaywalk::search

// Defined by each generator's file.
namespace jaywalk::search::generator {

#define JAYWALK_GENERATOR(identifier, name, summary)            \
  namespace identifier {                                        \
  std::span<const NumberParameter> parameters();                \
  std::unique_ptr<Generator> make(const GeneratorSetup& setup); \
  }
#include "search/generators.def"
#undef JAYWALK_GENERATOR

}  // namespace jaywalk::search::generator
