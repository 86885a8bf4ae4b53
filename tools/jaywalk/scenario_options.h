#pragma once

// The options that `run` and `compare` share: how a scenario is changed from the command line, and
// how it is made ready.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/trial.h"
#include "tools/jaywalk/arguments.h"
#include "tools/jaywalk/console.h"

namespace jaywalk {

inline constexpr std::array kScenarioOptions = {
    OptionSpec{"set", "KEY=VALUE",
               "another value for a key of the scenario, as a dotted path\n"
               "(world.length=80); repeatable"},
    OptionSpec{"preset", "NAME", "begin with these values instead of the scenario's preset"},
    OptionSpec{"seed", "N", "the seed from which all chance derives"},
    OptionSpec{"no-check", "", "leave out the warnings of `jaywalk check`"},
};

/// More pedestrians than this are a slip.
inline constexpr std::uint64_t kMaxAgents = 10'000;

/// The file names a scenario.
[[nodiscard]] bool is_scenario_file(const std::string& path);

/// How the options of `arguments` change a scenario, with `behaviours` in place of its own if there
/// are any.
[[nodiscard]] ScenarioOptions scenario_options(const Arguments& arguments,
                                               std::vector<std::string> behaviours);

/// Reads the scenario with the options of `arguments`, `behaviours` in place of its own if there
/// are any, and compiles its programs; reports what is wrong and returns null if that fails. Says
/// what `check` warns of, unless --no-check is given.
[[nodiscard]] std::shared_ptr<const PreparedScenario> prepare_scenario(
    const std::string& path, const Arguments& arguments, std::vector<std::string> behaviours,
    Console& console);

}  // namespace jaywalk
