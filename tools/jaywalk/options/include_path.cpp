// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/include_path.h"

#include <filesystem>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/shipped.h"

namespace jaywalk {

bool is_folder(OptionName option, const std::string& folder, Diagnostics& diagnostics) {
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored)) return true;
  diagnostics.error(option.dashed(), fmt::format("there is no folder '{}'", folder));
  return false;
}

IncludePath parse_include_path(const Arguments& arguments, Diagnostics& diagnostics) {
  IncludePath path;
  path.files = files_on_disk();
  for (std::string& folder : arguments.texts(option::kInclude)) {
    if (is_folder(option::kInclude, folder, diagnostics)) path.folders.push_back(std::move(folder));
  }
  for (const std::string& folder : arguments.texts(option::kAllowRead)) {
    if (is_folder(option::kAllowRead, folder, diagnostics)) path.files.allow_reading(folder);
  }
  for (const std::string& mapping : arguments.texts(option::kMap)) {
    const auto equals = mapping.find('=');
    if (equals == std::string::npos || equals == 0) {
      diagnostics.error(option::kMap.dashed(),
                        fmt::format("expected PREFIX=FOLDER, found '{}'", mapping),
                        "write it as --map '$jasonJar=FOLDER'");
    } else {
      path.mapped.emplace_back(mapping.substr(0, equals), mapping.substr(equals + 1));
    }
  }
  return path;
}

std::optional<IncludePath> read_include_path(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  IncludePath path = parse_include_path(arguments, diagnostics);
  if (!diagnostics.has_errors()) return path;
  console.report(diagnostics);
  return std::nullopt;
}

}  // namespace jaywalk
