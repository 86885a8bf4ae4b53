// SPDX-License-Identifier: Apache-2.0
#pragma once

// Requirements in temporal logic over the signals that a program returns for a test. Read
// experiment/judge/assertions/robustness.h and scaling.h first.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "env/config/reader.h"
#include "experiment/judge/assertions/expression.h"
#include "search/suts/scaling.h"

namespace jaywalk::search {

/// The name of the signal that every program returns: the time of each value.
inline constexpr std::string_view kTimeSignal = "time";

/// A signal that a program returns, a list of numbers.
struct ReturnedSignal {
  std::string name;
  SignalRange range;
};

struct Requirement {
  std::string id;
  stl::Expression condition;
  /// Its formula with robustness from -1 to 1; none: the robustness is divided by `scale`.
  std::optional<stl::Expression> scaled;
  double scale = 1;
};

/// By how much a test kept a requirement: negative if it did not, else 0 or more.
struct Robustness {
  /// In the unit of its comparisons.
  double own = 0;
  /// Without a unit, from -1 to 1; above 0 if it was kept.
  double scaled = 0;
};

class Requirements {
 public:
  std::vector<ReturnedSignal> signals;
  std::vector<Requirement> all;

  /// `values`: of `time`, then of each signal. REQUIRES: at least two for each, as many for all,
  /// the times evenly spaced.
  [[nodiscard]] std::vector<Robustness> judge(std::span<const std::vector<double>> values) const;
};

/// The keys `signals` and `requirements` of a SUT; signals have to be read first. `times`: which
/// there can be.
void read_signals(const ConfigNode& node, const ConfigReader& reader, Requirements& requirements);
void read_requirements(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                       SignalRange times, Requirements& requirements);

/// Why a program's times are none, in words for people; empty if they are.
[[nodiscard]] std::string why_no_times(std::span<const double> times);

}  // namespace jaywalk::search
