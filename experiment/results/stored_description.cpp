// SPDX-License-Identifier: Apache-2.0
// How an experiment's description is kept in a store's tables.

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "experiment/results/store/geopackage.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/store/store_file.h"

namespace jaywalk {
namespace {

void write_judging(Database& database, const ExperimentDescription& description) {
  Statement option(database, "INSERT INTO options (name, value) VALUES (?, ?)");
  for (const std::string& file : description.assertion_files) option.run("assertions", file);
  if (description.metrics) option.run("metrics", "");
}

void write_options(Database& database, const ExperimentDescription& description) {
  Statement option(database, "INSERT INTO options (name, value) VALUES (?, ?)");
  if (description.preset) option.run("preset", *description.preset);
  for (const std::string& set : description.sets) option.run("set", set);
  for (const std::string& behaviour : description.behaviour_options) {
    option.run("behaviour", behaviour);
  }
  for (const std::string& folder : description.include.folders) option.run("include", folder);
  for (const auto& [prefix, folder] : description.include.mapped) {
    option.run("map", fmt::format("{}={}", prefix, folder));
  }
  write_judging(database, description);
}

void write_plan(Database& database, const ExperimentDescription& description) {
  Statement behaviour(database, "INSERT INTO behaviours (name, code_lines) VALUES (?, ?)");
  Statement parameter(database, "INSERT INTO parameters (behaviour, name, value) VALUES (?, ?, ?)");
  for (const StoredBehaviour& each : description.behaviours) {
    behaviour.run(each.name, each.code_lines);
    for (const auto& [name, value] : each.parameters) parameter.run(each.name, name, value);
  }
  Statement agents(database, "INSERT INTO agent_numbers (agents) VALUES (?)");
  for (const std::uint32_t number : description.agents) agents.run(number);
  Statement vehicle(database, "INSERT INTO vehicles (name) VALUES (?)");
  for (const std::string& name : description.vehicles) vehicle.run(name);
}

void read_options(Database& database, ExperimentDescription& description) {
  Statement row(database, "SELECT name, value FROM options ORDER BY id");
  while (row.step()) {
    const std::string option = row.text(0);
    if (option == "preset") description.preset = row.text(1);
    if (option == "set") description.sets.push_back(row.text(1));
    if (option == "behaviour") description.behaviour_options.push_back(row.text(1));
    if (option == "include") description.include.folders.push_back(row.text(1));
    if (option == "map") {
      const std::string mapping = row.text(1);
      const std::size_t equals = std::min(mapping.find('='), mapping.size());
      description.include.mapped.emplace_back(mapping.substr(0, equals),
                                              mapping.substr(std::min(equals + 1, mapping.size())));
    }
    if (option == "assertions") description.assertion_files.push_back(row.text(1));
    if (option == "metrics") description.metrics = true;
  }
}

void read_plan(Database& database, ExperimentDescription& description) {
  Statement behaviour(database, "SELECT name, code_lines FROM behaviours ORDER BY id");
  while (behaviour.step()) {
    description.behaviours.push_back(
        {.name = behaviour.identifier(0), .code_lines = behaviour.integer<std::uint64_t>(1)});
  }
  Statement parameter(database, "SELECT behaviour, name, value FROM parameters ORDER BY id");
  while (parameter.step()) {
    for (StoredBehaviour& each : description.behaviours) {
      if (each.name == parameter.text(0)) {
        each.parameters.emplace_back(parameter.label(1), parameter.text(2));
      }
    }
  }
  Statement agents(database, "SELECT agents FROM agent_numbers ORDER BY id");
  while (agents.step()) description.agents.push_back(agents.integer<std::uint32_t>(0));
  Statement vehicle(database, "SELECT name FROM vehicles ORDER BY id");
  description.vehicles.clear();
  while (vehicle.step()) description.vehicles.push_back(vehicle.label(0));
}

// More than any scenario can ask for; nothing that is counted with them wraps.
constexpr std::uint32_t kMaxTestedAgents = 1'000'000;
constexpr std::uint64_t kMaxFirstTest = std::uint64_t{1} << 53U;

/// Whether the numbers can be reckoned with.
bool sensible(const ExperimentDescription& description) {
  const auto cells = static_cast<std::int64_t>(jaywalk::cells(description));
  const Shard& shard = description.shard;
  const bool some_agents = std::ranges::none_of(description.agents, [](std::uint32_t agents) {
    return agents == 0 || agents > kMaxTestedAgents;
  });
  return some_agents && description.first_test <= kMaxFirstTest && cells > 0 &&
         description.tests > 0 && description.tests <= kMaxTests &&
         cells <= kMaxTestId / static_cast<std::int64_t>(description.tests) && shard.index > 0 &&
         shard.index <= shard.count && description.tick_s > 0;
}

}  // namespace

void write_description(Database& database, const ExperimentDescription& description) {
  write_versions(database, kStoreVersion, description.version);
  if (!description.simulator.empty()) {
    Statement(database, "INSERT INTO versions (subject, version) VALUES ('simulator', ?)")
        .run(description.simulator);
  }
  const auto anchored = [&]<class T>(T Anchor::*field) -> std::optional<T> {
    if (!description.anchor) return std::nullopt;
    return *description.anchor.*field;
  };
  Statement(database, "INSERT INTO experiment VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run(description.scenario, description.seed, description.first_test, description.tests,
           description.tick_s, name(description.level), description.shard.index,
           description.shard.count, anchored(&Anchor::epsg), anchored(&Anchor::easting_m),
           anchored(&Anchor::northing_m), anchored(&Anchor::bearing_deg));
  write_options(database, description);
  write_plan(database, description);
  write_inputs(database, description.inputs);
}

void write_judging(Database& database, const ExperimentDescription& before,
                   const ExperimentDescription& now) {
  database.execute("DELETE FROM options WHERE name IN ('assertions', 'metrics')");
  write_judging(database, now);
  write_inputs(database, std::span(now.inputs).subspan(before.inputs.size()));
}

namespace {

Result<ExperimentDescription> read_description(Database& database, const std::string& path) {
  ExperimentDescription description;
  Statement row(
      database,
      "SELECT scenario, seed, first_test, tests, tick_s, level, shard, shards, epsg, easting, "
      "northing, bearing FROM "
      "experiment WHERE id = 1");
  bool found = row.step();
  if (found) {
    description.scenario = row.text(0);
    description.seed = static_cast<std::uint64_t>(row.number(1));
    description.first_test = row.integer<std::uint64_t>(2);
    description.tests = row.integer<std::uint64_t>(3);
    description.tick_s = row.real(4);
    const auto level = parse_store_level(row.text(5));
    description.level = level.value_or(StoreLevel::found);
    description.shard = {.index = row.integer<std::uint32_t>(6),
                         .count = row.integer<std::uint32_t>(7)};
    if (!row.is_null(8)) {
      description.anchor = Anchor{.epsg = row.integer<int>(8),
                                  .easting_m = row.real(9),
                                  .northing_m = row.real(10),
                                  .bearing_deg = row.real(11)};
    }
    found = level.has_value();
  }
  description.version =
      database.text("SELECT version FROM versions WHERE subject = 'jaywalk'").value_or("");
  description.simulator =
      database.text("SELECT version FROM versions WHERE subject = 'simulator'").value_or("");
  read_options(database, description);
  read_plan(database, description);
  description.inputs = read_inputs(database);
  if (database.failure()) return store_error(path, trouble_with(database));
  if (!found || !sensible(description)) {
    return store_error(path, "the store is damaged: its description makes no sense");
  }
  if (auto why = damage_of(description.inputs)) return store_error(path, std::move(*why));
  return description;
}

}  // namespace

Result<DescribedStore> described(Result<std::unique_ptr<Database>> opened,
                                 const std::string& path) {
  if (!opened) return std::move(opened.diagnostics());
  auto description = read_description(*opened.value(), path);
  if (!description) return std::move(description.diagnostics());
  return DescribedStore{std::move(opened).value(), std::move(description).value()};
}

}  // namespace jaywalk
