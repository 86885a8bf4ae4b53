// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which test of a store is meant: the options that `replay` and `explain` share.

#include <array>
#include <optional>
#include <string>

#include "experiment/results/reader.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr std::array kStoredTestOptions = {
    OptionSpec{option::kTest, "N",
               "the test's number (default: the first that met the precondition)"},
    OptionSpec{option::kAgents, "N", "with this number of agents"},
    OptionSpec{option::kBehaviour, "NAME", "of this behaviour"},
    OptionSpec{option::kDefect, "NAME",
               "with this defect of the AV, beside the same test of the healthy\n"
               "one (without --test: the first that kills it)"},
};

/// An option of every command that runs a store's tests again.
inline constexpr OptionSpec kAllowCommandsOption{
    option::kAllowCommands, "",
    "start the command that the stored scenario names, if it does (an\n"
    "AV of one's own): only for stores that you trust"};

[[nodiscard]] Commands commands_of(const Arguments& arguments);

/// The store named by the only operand; null after reporting an error.
[[nodiscard]] std::unique_ptr<ResultsReader> open_results(const Arguments& arguments,
                                                          std::string_view command,
                                                          Console& console);

/// The first stored test that the options allow: one that met the precondition, if none is named.
/// Nothing after reporting that there is none.
[[nodiscard]] std::optional<StoredTest> find_stored_test(const ResultsReader& store,
                                                         const Arguments& arguments,
                                                         Console& console);

}  // namespace jaywalk
