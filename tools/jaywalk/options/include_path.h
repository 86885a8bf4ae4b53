// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where included files are looked for, as the options --include and --map say.

#include <array>
#include <optional>

#include "interpreter/syntax/load.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr std::array kIncludeOptions = {
    OptionSpec{option::kInclude, "FOLDER",
               "look for included files here, too; repeatable (the installed\n"
               "agents are in $jaywalk/crossing)"},
    OptionSpec{option::kMap, "PREFIX=FOLDER",
               "what stands for a prefix of included files: '$jasonJar=DIR';\n"
               "repeatable"},
    OptionSpec{option::kAllowRead, "FOLDER",
               "programs may read files in this folder, too; repeatable (else those\n"
               "of their own and their project's folder, of --include and --map)"},
};

/// Adds errors in the options to the diagnostics.
[[nodiscard]] IncludePath parse_include_path(const Arguments& arguments, Diagnostics& diagnostics);
/// Whether there is a folder that an option names; if not, that is added to the diagnostics.
[[nodiscard]] bool is_folder(OptionName option, const std::string& folder,
                             Diagnostics& diagnostics);
/// Nothing after reporting errors in the options.
[[nodiscard]] std::optional<IncludePath> read_include_path(const Arguments& arguments,
                                                           Console& console);

}  // namespace jaywalk
