#include "experiment/export/validate.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "experiment/export/program.h"

namespace jaywalk {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The folder's schema whose name has the word; of several parts the `core` one, else the last.
std::string find_schema(const std::string& folder, std::string_view word) {
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = lower(entry.path().filename().string());
    if (name.ends_with(".xsd") && name.find(word) != std::string::npos) {
      found.push_back(entry.path().string());
    }
  }
  std::ranges::sort(found);
  const auto core = std::ranges::find_if(
      found, [](const std::string& path) { return lower(path).find("core") != std::string::npos; });
  if (core != found.end()) return *core;
  return found.empty() ? "" : found.back();
}

}  // namespace

void validate(const std::vector<std::string>& files, const std::string& folder,
              Diagnostics& diagnostics) {
  const std::string scenario_schema = find_schema(folder, "openscenario");
  const std::string road_schema = find_schema(folder, "opendrive");
  for (const std::string& file : files) {
    const bool road = file.ends_with(".xodr");
    if (!road && !file.ends_with(".xosc")) continue;
    const std::string& schema = road ? road_schema : scenario_schema;
    if (schema.empty()) {
      diagnostics.error(folder, fmt::format("has no schema of Open{}", road ? "DRIVE" : "SCENARIO"),
                        "the .xsd files are part of the standards at asam.net");
      return;
    }
    const int status = run_program({"xmllint", "--noout", "--schema", schema, file});
    if (status == 127) {
      diagnostics.error("xmllint", "is not installed", "it is in Debian's package libxml2-utils");
      return;
    }
    if (status != 0) diagnostics.error(file, "is not valid");
  }
}

}  // namespace jaywalk
