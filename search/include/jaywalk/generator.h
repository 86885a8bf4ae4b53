// SPDX-License-Identifier: Apache-2.0
#pragma once

// Generators propose test inputs and learn from their results. Jaywalk's own are listed here;
// another one is a class.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk::search {

struct GeneratorInfo {
  std::string_view name;
  std::string_view summary;
};

/// Those that come with Jaywalk, as `jaywalk list generators` shows them.
[[nodiscard]] std::vector<GeneratorInfo> generator_list();

/// A generator of your own, for one search.
class InputGenerator {
 public:
  virtual ~InputGenerator() = default;

  /// The next test input: as many numbers from -1 to 1 as the system's dimension. It must be valid;
  /// `is_valid` says, and each time that it is asked counts as a candidate. `spent` is the share of
  /// the budget that is spent, 0 to 1.
  [[nodiscard]] virtual std::vector<double> ask(
      const std::function<bool(std::span<const double> candidate)>& is_valid, double spent) = 0;
  /// The result of the latest proposed test: its fitness from 0 (harmless) to 1 (the worst), and
  /// whether it failed.
  virtual void tell(std::span<const double> input, double fitness, bool has_failed) = 0;
};

struct CustomGenerator {
  std::string name;
  /// Called for each search, with a seed that derives from that of the experiment.
  std::function<std::unique_ptr<InputGenerator>(std::size_t dimension, std::uint64_t seed)> make;
};

}  // namespace jaywalk::search
