// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/comparison/reporting.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "experiment/export/exporter.h"
#include "experiment/report/player/player.h"
#include "search/report/search_page.h"
#include "search/store/search_store.h"
#include "tools/jaywalk/console/output_files.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// Writes a page for each test that the report names, and links it. Whether all could be written.
bool write_replays(const ResultsReader& store, const std::string& html, reporting::ReportData& data,
                   Console& console) {
  const fs::path report(html);
  const fs::path folder = report.parent_path() / (report.stem().string() + "-replays");
  std::error_code error;
  if (fs::is_symlink(folder, error)) {  // which would lead the pages elsewhere
    console.error(fmt::format("cannot make the folder '{}': it is a link", folder.string()));
    return false;
  }
  fs::create_directories(folder, error);
  if (error) {
    console.error(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
    return false;
  }
  for (reporting::ReplayLink& link : data.replays) {
    const auto stored = store.test(test_id(store.description(), link.test));
    const auto page = stored ? replay_page(store, stored.value()) : stored.diagnostics();
    if (!page) {
      console.report(page.diagnostics());
      return false;
    }
    const std::string path = output_path(folder.string(), file_stem(store, link.test) + ".html");
    if (!write_output(path, page.value(), console, Links::replaced)) return false;
    link.page =
        fmt::format("{}/{}", folder.filename().string(), fs::path(path).filename().string());
  }
  return true;
}

std::optional<std::string> search_report(const std::string& path, Console& console) {
  const auto searches = search::read_search_store(path);
  if (!searches) {
    console.report(searches.diagnostics());
    return std::nullopt;
  }
  const search::SearchExperiment& experiment = searches.value().experiment;
  return search::to_html(experiment, search::group(experiment, searches.value().results));
}

}  // namespace

std::optional<std::string> stored_report(const std::string& store, const std::string& html,
                                         ReplayPages pages, Commands commands, Console& console,
                                         const std::vector<KillLine>& other_kills) {
  const auto reader = ResultsReader::open(store, commands);
  if (!reader && search::is_search_store(store)) return search_report(store, console);
  if (!reader) {
    console.report(reader.diagnostics());
    return std::nullopt;
  }
  auto data = reporting::read_report_data(*reader.value());
  if (!data) {
    console.report(data.diagnostics());
    return std::nullopt;
  }
  add_kills(other_kills, data.value().comparison.kills);
  if (pages == ReplayPages::beside &&
      !write_replays(*reader.value(), html, data.value(), console)) {
    return std::nullopt;
  }
  return reporting::render_report(data.value());
}

std::string unstored_report(const UnstoredTests& tests) {
  reporting::ReportData data{.comparison = tests.comparison,
                             .description = tests.description,
                             .prepared = tests.prepared,
                             .assertions = tests.criteria.assertions};
  const auto& behaviours = data.description.behaviours;
  for (const Summary& summary : data.comparison.summaries) {
    const auto behaviour = std::ranges::find(behaviours, summary.behaviour, &StoredBehaviour::name);
    data.facts.push_back(tests.facts.facts(static_cast<std::size_t>(behaviour - behaviours.begin()),
                                           summary.agents));
  }
  return reporting::render_report(data);
}

}  // namespace jaywalk
