// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads the SUT of an experiment, by the functions that each SUT's file defines for its row of the
// table. Read env/config/reader.h and search/sut.h first.

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "env/config/reader.h"
#include "env/number_parameter.h"
#include "env/vehicle/vehicle.h"
#include "experiment/scenario/scenario.h"
#include "search/sut.h"

namespace jaywalk::search {

/// A file that agents' learned choices are read from. SUTs with other agents leave it to those
/// whose it is.
struct OfferedPolicy {
  ValueOrigin origin;
  bool is_taken = false;
  /// Why it is not for the last one that left it; empty: that has no agents who learn.
  std::string why_not;
};
/// By their paths.
using OfferedPolicies = std::map<std::string, OfferedPolicy>;

/// The keys of a SUT. Errors go to the reader's diagnostics.
struct SutSetup {
  const ConfigNode& node;
  std::string path;
  const ConfigReader& reader;
  /// The folder that paths are relative to; empty: the current folder.
  std::string folder;
  /// The source of the agents' programs.
  SourceFiles files;
  IncludeFolders include;
  /// The AV's defects to search with, one after another.
  std::span<const VehicleDefect> defects;
  /// No test may be run to see whether it can be.
  bool untried = false;
  /// Receives those that the SUT is offered.
  OfferedPolicies* policies = nullptr;
};

struct SutKind {
  std::string_view name;
  std::string_view summary;
  /// Null after an error, at least where there is nothing to go on with.
  std::shared_ptr<const SutModel> (*read)(const SutSetup& setup);
};

[[nodiscard]] std::span<const SutKind> sut_kinds();

/// Reads the value of a key.
using KeyReader = std::function<void(const ConfigNode& value, const std::string& path)>;

/// Read, check, store; a number times `factor`.
[[nodiscard]] KeyReader number_into(double& target, const ConfigReader& reader, NumberRange range,
                                    double factor = 1);
template <class T>
[[nodiscard]] KeyReader integer_into(T& target, const ConfigReader& reader, IntegerRange range) {
  return [&target, &reader, range](const ConfigNode& value, const std::string&) {
    if (const auto read = reader.integer(value, range)) target = static_cast<T>(*read);
  };
}
/// Keys for numbers by name into `values`, which are in the order of `parameters`.
[[nodiscard]] std::vector<ConfigKey> parameter_keys(std::span<const NumberParameter> parameters,
                                                    const ConfigReader& reader,
                                                    std::vector<double>& values);

namespace sut {
#define JAYWALK_SUT(identifier, name, summary)                 \
  namespace identifier {                                       \
  std::shared_ptr<const SutModel> read(const SutSetup& setup); \
  }
#include "search/suts.def"
#undef JAYWALK_SUT
}  // namespace sut

}  // namespace jaywalk::search
