// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options that `run` and `compare` share: how a scenario is changed from the command line, and
// how it is made ready.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/test_run/prepared_scenario.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr OptionSpec kNoCheckOption{option::kNoCheck, "",
                                           "leave out the warnings of `jaywalk check`"};

inline constexpr std::array kScenarioOptions = {
    OptionSpec{option::kSet, "KEY=VALUE",
               "another value for a key of the scenario, as a dotted path\n"
               "(world.length=80); repeatable"},
    OptionSpec{option::kPreset, "NAME", "begin with these values instead of the scenario's preset"},
    OptionSpec{option::kSeed, "N", "the seed from which all chance derives"},
    kNoCheckOption,
};

/// The policy by which agents with plans learned(P) choose: the scenario's `policy`.
inline constexpr OptionSpec kPolicyOption{
    option::kPolicy, "FILE",
    "what `jaywalk learn` has written, for the behaviour that it is of;\nrepeatable"};

/// The limits of one test: the scenario's `experiment.limits`.
inline constexpr std::array kLimitOptions = {
    OptionSpec{option::kMaxCycles, "N",
               "of one test, which ends errored beyond: reasoning cycles of one\n"
               "agent, as the next three"},
    OptionSpec{option::kMaxInferences, "N",
               "inferences of all agents (default 200000000; 0: no limit)"},
    OptionSpec{option::kMaxMemory, "MB",
               "memory of one agent, and of all together (default 1024, and half\n"
               "of the machine's)"},
    OptionSpec{option::kTimeout, "S",
               "seconds by the wall clock (default: no limit): the one limit\n"
               "whose outcome depends on the machine"},
};

/// The file names a scenario.
[[nodiscard]] bool is_scenario_file(const std::string& path);

/// The settings of kLimitOptions in the form of `--set`, below that key: stored tests keep them.
/// Adds errors.
[[nodiscard]] std::vector<std::string> limit_sets(const Arguments& arguments,
                                                  Diagnostics& diagnostics,
                                                  std::string_view within = "experiment.limits");

/// Adds an error for each key that two settings give: the second would hide the first.
void report_repeated_keys(const std::vector<std::string>& sets, Diagnostics& diagnostics);

/// How the options of `arguments`, and then `more_sets`, change a scenario, with `behaviours` in
/// place of its own if there are any.
[[nodiscard]] ScenarioOptions scenario_options(const Arguments& arguments,
                                               std::vector<std::string> behaviours,
                                               const std::vector<std::string>& more_sets = {});

/// Reads the scenario with the options of `arguments`, with `behaviours` instead of its own if
/// there are any, and compiles its programs; reports errors and returns null if that fails. Prints
/// the warnings of `check`, unless --no-check is given.
[[nodiscard]] std::shared_ptr<const PreparedScenario> prepare_scenario(
    const std::string& path, const Arguments& arguments, std::vector<std::string> behaviours,
    Console& console, const std::vector<std::string>& more_sets = {});

}  // namespace jaywalk
