// SPDX-License-Identifier: Apache-2.0
// Results stores that were changed, for every command that reads them.

#include "tests/fuzz/store_changes.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::stores {
namespace {

constexpr std::string_view kScenario =
    "world:\n  until: road_end\n  length: 40\n  road_end: 30\n  av: {model: braking, speed: 6}\n"
    "behaviours:\n  - {program: walker.asl, parameters: {radius: 15}}\n"
    "assertions: rules.yaml\nexperiment: {tests: 2, agents: \"1,2\", defects: [latency]}\n";

std::map<std::string, std::string> inputs() {
  std::map<std::string, std::string> files = walker_files();
  files["scenario.yaml"] = kScenario;
  files["rules.yaml"] = project_text("scenarios/assertions/crossing.yaml");
  return files;
}

std::vector<std::string> comparison(std::vector<std::string> more) {
  std::vector<std::string> words = {"compare", "scenario.yaml", "--threads",     "1",
                                    "--quiet", "--metrics",     "--store-level", "all"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Case comparison_case() {
  return {.files = inputs(),
          .agents = {},
          .commands = {comparison({"--store", "store.gpkg"})},
          .input = {}};
}

std::vector<std::string> reading_command(Choices& choices) {
  const std::string number(choices.one_of({"0", "1", "2", "99", "2147483648"}));
  const std::vector<std::vector<std::string>> commands = {
      {"replay", "store.gpkg", "--test", number},
      {"replay", "store.gpkg", "--html", "page.html"},
      {"replay", "store.gpkg", "--defect", "latency", "--html", "page.html"},
      {"report", "store.gpkg", "--html", "page.html"},
      {"report", "store.gpkg", "--html", "page.html", "--replays"},
      {"judge", "store.gpkg", "--json", "out.json", "--junit", "out.xml"},
      {"judge", "store.gpkg", "--metrics", "--write"},
      {"judge", "store.gpkg", "--test", number, "--metrics"},
      {"export", "store.gpkg", "--all", "--out", "out"},
      {"export", "store.gpkg", "--all", "--format", "csv", "--out", "out"},
      {"export", "store.gpkg", "--all", "--format", "trace", "--out", "out"},
      {"export", "store.gpkg", "--all", "--format", "json", "--out", "out"},
      {"coverage", "store.gpkg", "--json", "out.json"},
      {"coverage", "store.gpkg", "--coverage", "out.html", "--threads", "1"},
      {"explain", "store.gpkg", "--test", number, "--json", "out.json"},
      {"explain", "store.gpkg", "--defect", "latency"},
      {"merge", "all.gpkg", "store.gpkg", "--json", "out.json"},
      comparison({"--store", "store.gpkg", "--resume"}),
  };
  return commands[choices.below(commands.size())];
}

}  // namespace

Case make(Choices& choices) {
  static const Texts kCorpus = corpus("stores");
  const std::string sql = choices.once_in(4) ? one_of(choices, kCorpus) : std::string();
  ChangedStore store = change_store(choices, sound_store("stores", comparison_case()), sql);
  Case made{.files = inputs(), .agents = {}, .commands = {}, .input = {}};
  made.files["store.gpkg"] = std::move(store.bytes);
  made.files["how.sql"] = std::move(store.how);
  made.commands = {reading_command(choices), reading_command(choices)};
  made.outputs = {"store.gpkg", "out", "page", "all.gpkg"};
  return made;
}

}  // namespace jaywalk::fuzz::target::stores
