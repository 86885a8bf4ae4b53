#include "experiment/export/openscenario/validate.h"

#include <algorithm>
#include <compare>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string_view>

#include <fmt/format.h>

#include "experiment/export/exporter.h"

namespace jaywalk {
namespace {

struct Version {
  int major = 0;
  int minor = 0;

  friend auto operator<=>(const Version&, const Version&) = default;
};

/// A schema of a standard's root element; schemas of parts of it are no such ones.
struct Schema {
  std::string standard;
  std::optional<Version> version;
  std::string path;
};

/// Root elements and versions stand at the beginning of schemas and documents.
std::string beginning(const std::filesystem::path& path) {
  std::string text(16384, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

std::optional<Version> find_version(const std::string& text, const std::regex& pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, pattern)) return std::nullopt;
  return Version{std::stoi(found[1].str()), std::stoi(found[2].str())};
}

/// `ASAM OpenDRIVE V1.7.0`, or the name `opendrive_17_core.xsd`.
std::optional<Version> version_of_schema(const std::string& text, const std::string& name) {
  static const std::regex in_text("ASAM Open[A-Z]+ V([0-9]{1,3})\\.([0-9]{1,3})");
  static const std::regex in_name("(?:^|[^0-9])([0-9])[._]?([0-9])(?![0-9])");
  if (const auto version = find_version(text, in_text)) return version;
  return find_version(name, in_name);
}

std::vector<Schema> find_schemas(const std::string& folder) {
  std::vector<Schema> found;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() != ".xsd") continue;
    const std::string text = beginning(it->path());
    for (const std::string standard : {"OpenSCENARIO", "OpenDRIVE"}) {
      if (text.find(fmt::format("element name=\"{}\"", standard)) == std::string::npos) continue;
      found.push_back(
          {standard, version_of_schema(text, it->path().filename().string()), it->path().string()});
    }
  }
  std::ranges::sort(found, {}, &Schema::path);
  return found;
}

std::string name(const Schema& schema) {
  if (!schema.version) return schema.standard;
  return fmt::format("{} {}.{}", schema.standard, schema.version->major, schema.version->minor);
}

/// The schema of the version, or of the next later one, or a schema without a version.
const Schema* best_schema(const std::vector<Schema>& schemas, std::string_view standard,
                          Version version) {
  const Schema* best = nullptr;
  for (const Schema& each : schemas) {
    if (each.standard != standard || (each.version && *each.version < version)) continue;
    const bool better = best == nullptr || (each.version && !best->version) ||
                        (each.version && best->version && *each.version < *best->version);
    if (better) best = &each;
  }
  return best;
}

class Validation {
 public:
  Validation(const std::string& folder, Diagnostics& diagnostics)
      : folder_(folder), schemas_(find_schemas(folder)), diagnostics_(diagnostics) {}

  void check(const std::string& file) {
    const std::string standard = file.ends_with(".xodr") ? "OpenDRIVE" : "OpenSCENARIO";
    static const std::regex header("revMajor=\"([0-9]{1,3})\"\\s+revMinor=\"([0-9]{1,3})\"");
    const auto version = find_version(beginning(file), header);
    if (!version) {
      diagnostics_.error(file, "does not say its version in its header");
      return;
    }
    const std::string wanted = name({standard, version, {}});
    const Schema* const schema = best_schema(schemas_, standard, *version);
    if (schema == nullptr) {
      report_once(Severity::error, fmt::format("has no schema of {}", wanted),
                  "the .xsd files are part of the standards at asam.net");
      return;
    }
    if (schema->version != version) {
      report_once(Severity::warning,
                  fmt::format("has no schema of {}: {} takes its place", wanted, name(*schema)),
                  "");
    }
    const int status = run_program({"xmllint", "--noout", "--schema", schema->path, file});
    if (status == 127) {
      xmllint_ = false;
      diagnostics_.error("xmllint", "is not installed", "it is in Debian's package libxml2-utils");
    } else if (status != 0) {
      diagnostics_.error(file, fmt::format("is not valid by {}", schema->path));
    }
  }

  [[nodiscard]] bool can_go_on() const { return xmllint_; }

 private:
  void report_once(Severity severity, std::string message, std::string hint) {
    if (std::ranges::find(reported_, message) != reported_.end()) return;
    reported_.push_back(message);
    diagnostics_.add({.severity = severity,
                      .message = std::move(message),
                      .hint = std::move(hint),
                      .subject = folder_});
  }

  const std::string& folder_;
  std::vector<Schema> schemas_;
  Diagnostics& diagnostics_;
  std::vector<std::string> reported_;
  bool xmllint_ = true;
};

}  // namespace

void validate(const std::vector<std::string>& files, const std::string& folder,
              Diagnostics& diagnostics) {
  Validation validation(folder, diagnostics);
  for (const std::string& file : files) {
    if (!file.ends_with(".xodr") && !file.ends_with(".xosc")) continue;
    validation.check(file);
    if (!validation.can_go_on()) return;
  }
}

}  // namespace jaywalk
