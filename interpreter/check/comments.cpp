// Comments that allow what is never warned of.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/support/silenced.h"

namespace jaywalk {

void unknown_codes(Checking& checking) {
  std::vector<std::string> names;
  for (const CheckInfo& check : checks()) names.emplace_back(check.name);
  for (CheckedFile& file : checking.files()) {
    for (const AllowedCode& allowed : allowed_codes(*file.file->source)) {
      if (std::ranges::find(names, allowed.code) != names.end()) continue;
      std::string hint = did_you_mean(allowed.code, names);
      if (hint.empty()) hint = "`jaywalk check --list` names them";
      checking.warn(file, allowed.span, fmt::format("there is no warning '{}'", allowed.code),
                    std::move(hint));
    }
  }
}

}  // namespace jaywalk
