#include "experiment/export/exporter.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiment/export/exporters.h"
#include "experiment/scenario/files/write_file.h"

namespace jaywalk {

std::span<const Exporter> exporters() {
#define JAYWALK_EXPORTER(name, function, summary) Exporter{name, summary, function},
  static constexpr std::array kExporters{
#include "experiment/export/exporters.def"
  };
#undef JAYWALK_EXPORTER
  return kExporters;
}

const Exporter* find_exporter(std::string_view name) {
  const std::span<const Exporter> all = exporters();
  const auto found = std::ranges::find(all, name, &Exporter::name);
  return found == all.end() ? nullptr : &*found;
}

std::string file_stem(const ResultsReader& store, const TestKey& test) {
  return fmt::format("{}-{}-test-{}", store.description().behaviours[test.behaviour].name,
                     test.agents, test.number);
}

bool write_export(const ExportRequest& request, const std::string& name, std::string_view text,
                  std::vector<std::string>& written, Diagnostics& diagnostics) {
  return write_export(
      request, name,
      [text](const TextSink& sink) {
        sink(text);
        return true;
      },
      written, diagnostics);
}

bool write_export(const ExportRequest& request, const std::string& name, const TextSource& source,
                  std::vector<std::string>& written, Diagnostics& diagnostics) {
  std::string path = output_path(request.folder, name);
  if (const auto why = write_file(path, source, Links::replaced)) {
    if (why->empty()) return false;
    diagnostics.error(path, fmt::format("cannot be written: {}", *why));
    return false;
  }
  written.push_back(std::move(path));
  return true;
}

}  // namespace jaywalk
