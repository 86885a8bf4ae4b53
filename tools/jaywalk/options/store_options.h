// SPDX-License-Identifier: Apache-2.0
#pragma once

// `--store` and what belongs to it: where tests are kept, and which of them.

#include <array>
#include <optional>
#include <string>

#include "experiment/results/writer.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr OptionSpec kStoreOption{option::kStore, "FILE",
                                         "keep every test in this GeoPackage (.gpkg), which is new",
                                         Written::file};

inline constexpr std::array kStoreOptions = {
    kStoreOption,
    OptionSpec{option::kStoreLevel, "LEVEL",
               "whose positions are kept at every tick: summary (no\n"
               "test's), found (default: of tests that met the\n"
               "precondition), all"},
    OptionSpec{option::kResume, "", "run only what the store does not have yet"},
    OptionSpec{option::kRetryErrors, "", "with --resume: run tests that ended errored again"},
    OptionSpec{option::kShard, "I/N",
               "run the I-th of N parts of the tests; needs --store.\n"
               "`jaywalk merge` puts the parts together"},
};

/// The options of --store; nothing without it. Adds errors.
[[nodiscard]] std::optional<StoreOptions> read_store_options(const Arguments& arguments,
                                                             Diagnostics& diagnostics);

/// Whether a store has all that it was given; false after reporting why not.
[[nodiscard]] bool is_kept(const std::optional<std::string>& failure, const std::string& path,
                           Console& console);

}  // namespace jaywalk
