// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scenario: the world, the behaviours and the defaults of an experiment, as a YAML file says it
// (docs/reference/scenarios.md is the reference of its keys). Values are layered: the preset's, the
// file's, then each `--set`; the last one counts. Tests run a scenario that was prepared; see
// test_run.h.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "env/config/parameter_settings.h"
#include "env/config/section_reader.h"
#include "env/environments.h"
#include "env/world/world_spec.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/judge/situations/situations.h"
#include "experiment/policy/learning_spec.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/support/source_files.h"

namespace jaywalk {

/// The place of a scenario's plane on the Earth, for maps. No computation uses it: tests, measures
/// and recordings stay in the plane's own metres.
struct Anchor {
  /// A projected reference system whose unit is the metre, by its EPSG code: 27700, 32630, …
  int epsg = 0;
  /// The coordinates of the plane's origin.
  double easting_m = 0;
  double northing_m = 0;
  /// The direction of the AV's way (the plane's y), clockwise from the system's north.
  double bearing_deg = 0;

  friend bool operator==(const Anchor&, const Anchor&) = default;
};

class ProgramCopies;

/// Parameters of some agents only, by their numbers, from 1.
struct AgentSettings {
  std::vector<std::uint32_t> agents;
  std::vector<ParameterSetting> parameters;
};

/// Agents of a behaviour that run a program of their own.
struct TeamMember {
  std::vector<std::uint32_t> agents;
  std::string program;
  ValueOrigin origin;
};

struct BehaviourSpec {
  /// Unique in the scenario; the program's file name without `.asl` unless given.
  std::string name;
  /// The program's file, found from the current folder.
  std::string program;
  /// Programs of some agents by their numbers; the others run `program`.
  std::vector<TeamMember> team;
  std::vector<ParameterSetting> parameters;
  std::vector<AgentSettings> agents;
  ValueOrigin origin;
};

/// Limits beyond which a test ends errored. All but the time have the same effect on any machine.
struct TestLimits {
  /// Reasoning cycles of one agent; 0: no limit but that of a tick.
  std::uint64_t cycles = 0;
  /// Steps of queries, of all agents together; 0: no limit.
  std::uint64_t inferences = kUsualInferences;
  /// MB (2^20 bytes) that one agent, and all of them together, may own; 0: the interpreter's own
  /// limits, 1 GB and half of the machine's memory.
  std::uint64_t memory_mb = 0;
  /// By the wall clock; 0: no limit.
  double time_s = 0;

  /// Seconds of reasoning; tests of the shipped scenarios take less than a hundredth.
  static constexpr std::uint64_t kUsualInferences = 200'000'000;
  /// More cycles or inferences, and more MB, than these are a slip.
  static constexpr std::uint64_t kMost = 1'000'000'000'000'000;
  static constexpr std::uint64_t kMostMegabytes = 1'000'000'000;
};

/// The defaults of an experiment; options of the command line replace them.
struct ExperimentSpec {
  std::uint64_t tests = 1000;
  /// The numbers of agents to compare, in this order.
  std::vector<std::uint32_t> agents{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 15, 20};
  std::uint64_t seed = 0;
  /// Defects that each test is run with beside the healthy AV (compare/kills/kills.h).
  std::vector<VehicleDefect> defects;
  /// Models of the AV that each test is run with (compare/avs/av_ranking.h); empty: the world's.
  std::vector<std::string> avs;
  /// Tests in a generation: those of later ones believe what earlier ones covered; 0: none do.
  std::uint64_t feedback = 0;
  TestLimits limits;
  /// Which situations tests with one agent can meet at all, as `jaywalk reach` has found.
  ReachableBins reachable;
};

/// The folders in which programs look for included files, after their own folder (IncludePath).
struct IncludeFolders {
  std::vector<std::string> folders;
  std::vector<std::pair<std::string, std::string>> mapped;
};

struct Scenario {
  /// The file's name.
  std::string name;
  /// Empty if it began with none.
  std::string preset;
  /// The scenario's world; shared, since it does not change.
  std::shared_ptr<const WorldSpec> world = default_world();
  std::vector<BehaviourSpec> behaviours;
  /// The programs of the world's other agents, in their order.
  std::vector<BehaviourSpec> actors;
  ExperimentSpec experiment;
  /// How `jaywalk learn` has agents learn, and the texts of policies that they have learned: a
  /// behaviour's agents choose by the first one that has its options.
  LearningSpec learning;
  std::vector<SourcePtr> policies;
  /// The world's place on the Earth, for stores.
  std::optional<Anchor> anchor;
  /// The assertions by which tests are judged.
  std::vector<Assertion> assertions;
  /// The texts that it was read from (programs are read when it is prepared), and where they and
  /// the programs are.
  std::vector<SourcePtr> sources;
  SourceFiles files;
  IncludeFolders include;
  /// Where each key was given, for errors in its value that later checks find.
  ValueOrigins origins;
  /// Warnings about values that are allowed but unusual.
  Diagnostics warnings;
  /// Copies of the AV's external controller and its twin that their commands name; null if there
  /// are none.
  std::shared_ptr<const ProgramCopies> programs;
};

struct ScenarioOptions {
  /// Replaces the file's `preset`.
  std::optional<std::string> preset;
  /// `dotted.path=value`, in order, as given to `--set`.
  std::vector<std::string> sets;
  /// For entries of `sets` whose value came from another option: that value, as a source with the
  /// option's name, so that errors are shown there.
  std::map<std::string, SourcePtr> given_by;
  /// Names of the scenario's behaviours, or paths of programs: these and no others, in this order.
  std::vector<std::string> behaviours;
  /// The source of the scenario and all files that it names: the disk, unless copies are given.
  SourceFiles files;
  IncludeFolders include;
};

/// A scenario larger than this is refused.
inline constexpr std::size_t kMaxScenarioBytes = std::size_t{1} << 20U;

[[nodiscard]] Result<Scenario> read_scenario(const std::string& path,
                                             const ScenarioOptions& options = {});
/// Reads a scenario from a text in memory. Programs are found relative to the folder in the
/// source's name.
[[nodiscard]] Result<Scenario> parse_scenario(const SourcePtr& source,
                                              const ScenarioOptions& options = {});

}  // namespace jaywalk
