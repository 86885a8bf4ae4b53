// SPDX-License-Identifier: Apache-2.0
#pragma once

// A store's description of the experiment whose tests it holds: enough to run any of them again.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/results/store/geopackage.h"
#include "experiment/scenario/files/portable_names.h"
#include "experiment/test_run/prepared_scenario.h"

namespace jaywalk {

/// For which tests every actor is kept at every tick: none, those that met the precondition, all.
/// Outcomes, scores, events and assessments are kept of every test.
enum class StoreLevel { summary, found, all };

[[nodiscard]] std::string_view name(StoreLevel level);
[[nodiscard]] std::optional<StoreLevel> parse_store_level(std::string_view text);

/// The part of an experiment's tests that one process runs: those whose number leaves the remainder
/// `index` - 1. REQUIRES: 1 <= index <= count.
struct Shard {
  std::uint32_t index = 1;
  std::uint32_t count = 1;

  [[nodiscard]] bool has(std::uint64_t test) const { return test % count == index - 1; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// `2/4`. Nothing if it is not of that form, or there is no such shard.
[[nodiscard]] std::optional<Shard> parse_shard(std::string_view text);

/// A behaviour as the plan names it.
struct StoredBehaviour {
  std::string name;
  std::uint64_t code_lines = 0;
  /// Its parameters as the scenario sets them, `radius` and `15`; those of single agents with their
  /// number, `p2.radius`.
  std::vector<std::pair<std::string, std::string>> parameters;
};

struct ExperimentDescription {
  /// The scenario's file and the options that changed it (see ScenarioOptions).
  std::string scenario;
  std::optional<std::string> preset;
  std::vector<std::string> sets;
  std::vector<std::string> behaviour_options;
  IncludeFolders include;
  /// The files of `--assertions`, by their names among the inputs, and whether tests were measured.
  std::vector<std::string> assertion_files;
  bool metrics = false;
  /// The plan: behaviours x agents x tests, numbered from `first_test`.
  std::vector<StoredBehaviour> behaviours;
  std::vector<std::uint32_t> agents;
  /// The AVs that each of its tests is run with, by name; the first is that of the measures.
  std::vector<std::string> vehicles{"given"};
  std::uint64_t first_test = 0;
  std::uint64_t tests = 0;
  std::uint64_t seed = 0;
  /// Seconds from one tick to the next.
  double tick_s = 1;
  /// The reference system of its points; empty: a plane of their own.
  std::optional<Anchor> anchor;
  StoreLevel level = StoreLevel::found;
  Shard shard;
  /// The version of the program that ran the tests.
  std::string version;
  /// The simulator that moved the vehicles, and its version (simulator_version.h); empty: the world
  /// itself moved them.
  std::string simulator;
  std::vector<StoredInput> inputs;
  /// How paths were shortened in these names, for the messages of tests; not stored.
  PortableNames names;
};

/// Describes an experiment that is about to run. Options are those by which `prepared` was read.
[[nodiscard]] ExperimentDescription describe(const PreparedScenario& prepared,
                                             const ScenarioOptions& options,
                                             const ExperimentPlan& plan, std::uint64_t seed);

/// Removes paths of this machine from the names (portable_names.h). `files` are those that the
/// scenario was read from.
void make_portable(ExperimentDescription& description, const SourceFiles& files);

/// Takes note that its tests are judged by the assertions of these files, and whether they are
/// measured. Of two files of one name with different texts the second gets another name.
void add_judging(ExperimentDescription& description, std::span<const SourcePtr> files,
                 bool metrics);

/// The number under which a store keeps a test, from 1 in the order of the plan. Shards and the
/// whole run agree on it. REQUIRES: a test of the plan.
[[nodiscard]] std::int64_t test_id(const ExperimentDescription& description, const TestKey& test);
/// The id of the same test with the first vehicle.
[[nodiscard]] std::int64_t twin_id(const ExperimentDescription& description, TestKey test);
/// The inverse of test_id(). Nothing if the plan has no such test.
[[nodiscard]] std::optional<TestKey> find_test(const ExperimentDescription& description,
                                               std::int64_t id);

/// The plan of the described experiment, on one thread.
[[nodiscard]] ExperimentPlan plan_of(const ExperimentDescription& description);

/// The plan's pairs of behaviour and number of agents, for every vehicle.
[[nodiscard]] std::uint64_t cells(const ExperimentDescription& description);
/// How many tests its shard has in each cell.
[[nodiscard]] std::uint64_t tests_in_shard(const ExperimentDescription& description);

/// Why two stores do not belong to one experiment ("the seeds are 1 and 2"); empty if they do.
/// Level and shard may differ.
[[nodiscard]] std::string difference(const ExperimentDescription& left,
                                     const ExperimentDescription& right);

}  // namespace jaywalk
