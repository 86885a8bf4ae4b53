// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scenario made ready to run: its programs compiled, its worlds checked. Read scenario.h first.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "env/world/world_spec.h"
#include "experiment/policy/policy.h"
#include "experiment/scenario/scenario.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// A behaviour whose program is compiled and whose parameters are terms.
struct PreparedBehaviour {
  std::string name;
  std::string program_path;
  std::shared_ptr<const Program> program;
  /// Lines of AgentSpeak, of the program and all that it includes, without blank ones and comments.
  std::uint64_t code_lines = 0;
  std::vector<Parameter> parameters;
  /// The policy for choices among plans learned(P) (policy/policy.h); null: they are random.
  std::shared_ptr<const Policy> policy;
  /// The texts that `program` and the team's were made from: programs and all that they include.
  std::vector<SourcePtr> sources;
  /// Programs of single agents, by number from 1; the others run `program`.
  std::map<std::uint32_t, std::shared_ptr<const Program>> team;
  /// Parameters of single agents, by number from 1; they replace the common ones.
  std::map<std::uint32_t, std::vector<Parameter>> agent_parameters;
};

/// The folders in which a scenario's programs look for included files.
[[nodiscard]] IncludePath include_path(const Scenario& scenario);

/// A scenario made ready to run: immutable, shared by all tests on all threads.
class PreparedScenario {
 public:
  /// Loads and compiles the behaviours' programs and checks the parameters against their initial
  /// beliefs. Warnings (a missing include, say) are added to `warnings`.
  [[nodiscard]] static Result<std::shared_ptr<const PreparedScenario>> prepare(
      Scenario scenario, Diagnostics& warnings);

  [[nodiscard]] const Scenario& scenario() const { return scenario_; }
  [[nodiscard]] const std::vector<PreparedBehaviour>& behaviours() const { return behaviours_; }
  /// The programs of the world's actors, in their order.
  [[nodiscard]] const std::vector<PreparedBehaviour>& actors() const { return actors_; }
  [[nodiscard]] const std::shared_ptr<const SymbolTable>& symbols() const { return symbols_; }
  /// The texts of all files that it was made from, each once, in the order in which they were read:
  /// with copies of these (ScenarioOptions::files) it can be made again.
  [[nodiscard]] const std::vector<SourcePtr>& inputs() const { return inputs_; }
  /// The AVs that tests can be run with (tested_vehicles.h), by name, and the world with each.
  [[nodiscard]] const std::vector<std::string>& vehicles() const { return vehicles_; }
  [[nodiscard]] const PreparedWorld& world(std::size_t vehicle) const { return *worlds_[vehicle]; }

 private:
  struct PreparedVehicle {
    std::string name;
    std::unique_ptr<const PreparedWorld> world;
  };

  PreparedScenario(Scenario scenario, std::shared_ptr<const SymbolTable> symbols,
                   std::vector<PreparedBehaviour> behaviours, std::vector<PreparedBehaviour> actors,
                   std::vector<SourcePtr> inputs, std::vector<PreparedVehicle> vehicles);

  Scenario scenario_;
  std::shared_ptr<const SymbolTable> symbols_;
  std::vector<PreparedBehaviour> behaviours_;
  std::vector<PreparedBehaviour> actors_;
  std::vector<SourcePtr> inputs_;
  std::vector<std::string> vehicles_;
  std::vector<std::unique_ptr<const PreparedWorld>> worlds_;
};

}  // namespace jaywalk
