#pragma once

// Options that several commands have, and read alike.

#include <string>
#include <string_view>
#include <vector>

#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

/// All values of an option, each a list separated by commas, as one list.
[[nodiscard]] std::vector<std::string> listed(const Arguments& arguments, OptionName option);

/// --threads: as many as cores unless it is given, and never more than make sense.
[[nodiscard]] unsigned read_threads(const Arguments& arguments, Diagnostics& diagnostics);

}  // namespace jaywalk
