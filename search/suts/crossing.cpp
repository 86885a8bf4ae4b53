// SPDX-License-Identifier: Apache-2.0
// The pedestrians' world as a SUT: a scenario with a behaviour, some of whose values a search
// chooses; measured are the metrics of the recorded test and, if asked for, assertions. So search,
// random behaviour and BDI agents are compared on one footing.

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "env/config/parameter_settings.h"
#include "env/crossing/world.h"
#include "experiment/policy/learning_spec.h"
#include "experiment/scenario/scenario_schema.h"
#include "experiment/test_run/tested_vehicles.h"
#include "search/suts/crossing_run.h"
#include "search/suts/crossing_space.h"
#include "search/suts/crossing_starts.h"
#include "search/suts/suts.h"

namespace jaywalk::search {
namespace {

constexpr std::uint32_t kMostAgents = 100;

class CrossingModel : public SutModel {
 public:
  /// `defects`: the names of those that the AV can have.
  CrossingModel(CrossingSettings settings, std::shared_ptr<const CrossingSpace> space,
                std::vector<std::string> defects)
      : settings_(std::move(settings)),
        space_(std::move(space)),
        measures_(settings_),
        defects_(std::move(defects)) {}

  [[nodiscard]] const SearchSpace& space() const override { return *space_; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return measures_.kinds(); }
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    return std::make_unique<CrossingRun>(*space_, settings_, measures_);
  }
  [[nodiscard]] std::vector<SutSetting> settings() const override {
    return {{"scenario", settings_.scenario->name()},
            {"behaviour", settings_.behaviour},
            {"pedestrians", std::to_string(settings_.agents)},
            {"dimensions of the search", std::to_string(space_->dimension())}};
  }
  [[nodiscard]] std::vector<SourcePtr> inputs() const override { return settings_.inputs; }
  [[nodiscard]] const Scenario* scenario() const override {
    return settings_.parsed_scenario.get();
  }
  [[nodiscard]] std::vector<std::string> defects() const override { return defects_; }
  [[nodiscard]] std::shared_ptr<const SutModel> with_defect(std::size_t index) const override {
    CrossingSettings settings = settings_;
    settings.vehicle = index + 1;  // the first vehicle is healthy
    return std::make_shared<CrossingModel>(std::move(settings), space_, defects_);
  }
  [[nodiscard]] std::uint32_t agents() const override { return settings_.agents; }

 private:
  CrossingSettings settings_;
  std::shared_ptr<const CrossingSpace> space_;
  CrossingMeasures measures_;
  std::vector<std::string> defects_;
};

/// Reads the keys of the SUT and tries one test, so that mistakes are found at once.
class CrossingReader {
 public:
  explicit CrossingReader(const SutSetup& setup)
      : setup_(setup), reader_(setup.reader), starts_(setup) {}

  std::shared_ptr<const SutModel> read() {
    const auto ignored = [](const ConfigNode&, const std::string&) {};
    const std::vector<ConfigKey> keys{
        {"kind", ignored},
        {"scenario", [&](const ConfigNode& value, const std::string&) { read_scenario(value); }},
        {"behaviour",
         [&](const ConfigNode& value, const std::string&) {
           if (auto name = reader_.text(value, "a behaviour")) settings_.behaviour = *name;
         }},
        {"agents", integer_into(settings_.agents, reader_, {1, kMostAgents})},
        {"seed", integer_into(settings_.seed, reader_, {0, INT64_MAX})},
        {"starts",
         [&](const ConfigNode& value, const std::string& path) { starts_.read(value, path); }},
        {"assertions",
         [&](const ConfigNode& value, const std::string&) { read_assertions(value); }},
        {"metrics",
         [&](const ConfigNode& value, const std::string&) {
           const std::array choices = {Choice<bool>{"all", true}, Choice<bool>{"none", false}};
           if (const auto all = reader_.choice<bool>(value, choices)) settings_.metrics = *all;
         }},
        {"policy", [&](const ConfigNode& value, const std::string&) { read_policies(value); }},
        {"limits", [&](const ConfigNode& value, const std::string&) { read_limits(value); }},
        {"parameters", [&](const ConfigNode& value,
                           const std::string&) { read_dimensions(value, reader_, dimensions_); }},
    };
    reader_.read_map(setup_.node, setup_.path, keys);
    if (!settings_.scenario) {
      if (setup_.node.find("scenario") == nullptr) {
        reader_.error(setup_.node.origin, "no 'scenario' whose tests are searched");
      }
      return nullptr;
    }
    return make();
  }

 private:
  void read_scenario(const ConfigNode& value) {
    const auto path = reader_.text(value, "the path of a scenario");
    if (!path) return;
    Result<SourcePtr> source = setup_.files.read(path_in(setup_.folder, *path), kMaxScenarioBytes);
    if (source.ok()) {
      settings_.scenario = source.value();
    } else {
      reader_.error(value.origin, fmt::format("cannot read '{}'", *path));
    }
  }

  /// The path of a policy, or a list of them.
  void read_policies(const ConfigNode& node) {
    const auto read_one = [this](const ConfigNode& item) {
      const auto file = reader_.text(item, "the path of a policy");
      if (!file || setup_.untried || setup_.policies == nullptr) return;
      std::error_code error;
      const auto path = std::filesystem::absolute(path_in(setup_.folder, *file), error);
      if (!error) offered_.emplace_back(path.lexically_normal().string(), item.origin);
    };
    if (node.kind != ConfigNode::Kind::list) return read_one(node);
    for (const ConfigNode& item : node.items) read_one(item);
  }

  /// Takes those of the offered policies that are of the behaviour; false after reporting that one
  /// cannot be read.
  bool take_policies(const Scenario& scenario) {
    if (offered_.empty()) return true;
    Scenario without = scenario;
    without.policies.clear();
    Diagnostics ignored;
    const auto prepared = PreparedScenario::prepare(std::move(without), ignored);
    if (!prepared.ok()) return true;  // reported where it is tried
    for (const auto& [path, origin] : offered_) {
      const Result<SourcePtr> source = setup_.files.read(path, kMostPolicyBytes);
      if (!source.ok()) {
        reader_.error(origin, fmt::format("no policy is at '{}'", path),
                      "jaywalk learn writes them");
        return false;
      }
      OfferedPolicy& offered =
          setup_.policies->try_emplace(path, OfferedPolicy{origin}).first->second;
      const auto objection = objection_to(source.value(), *prepared.value());
      if (!objection) {
        offered.is_taken = true;
        settings_.policies.push_back(path);
      } else if (!objection->empty()) {
        offered.why_not = *objection;
      }
    }
    return true;
  }

  /// Reads the limits with the reader of the scenario's `experiment.limits`, which reports errors.
  void read_limits(const ConfigNode& node) {
    if (node.kind != ConfigNode::Kind::map) return reader_.unexpected(node, "limits of a test");
    for (const ConfigEntry& entry : node.entries) {
      if (const auto text = reader_.text(entry.value, "a number")) {
        settings_.limits.push_back(fmt::format("experiment.limits.{}={}", entry.key, *text));
      }
    }
  }

  void read_assertions(const ConfigNode& value) {
    const auto path = reader_.text(value, "the path of a file of assertions");
    if (!path) return;
    auto read =
        read_assertion_files({path_in(setup_.folder, *path)}, setup_.files, SameId::refused);
    if (read.ok()) {
      settings_.assertions = std::move(read.value().assertions);
      settings_.inputs = std::move(read.value().sources);
    } else {
      reader_.error(value.origin,
                    fmt::format("'{}': {}", *path, read.diagnostics().items().front().message));
    }
  }

  std::shared_ptr<const SutModel> make() {
    settings_.files = setup_.files;
    settings_.include = setup_.include;
    settings_.defects.assign(setup_.defects.begin(), setup_.defects.end());
    Result<Scenario> scenario = scenario_of(settings_, fixed_settings());
    if (!scenario.ok()) {
      reader_.error_in(setup_.node.origin, scenario.diagnostics());
      return nullptr;
    }
    if (!take_policies(scenario.value())) return nullptr;
    if (!settings_.policies.empty()) {
      scenario = scenario_of(settings_, fixed_settings());
      if (!scenario.ok()) {
        reader_.error_in(setup_.node.origin, scenario.diagnostics());
        return nullptr;
      }
    }
    keep_inputs(scenario.value());
    if (starts_.file()) settings_.inputs.push_back(starts_.file());
    const std::string name = scenario.value().behaviours.front().name;
    if (settings_.behaviour.empty()) settings_.behaviour = name;
    if (settings_.assertions.empty()) settings_.assertions = scenario.value().assertions;
    settings_.feedback = scenario.value().experiment.feedback;
    settings_.parsed_scenario = std::make_shared<const Scenario>(scenario.value());
    const CrossingSpec* const crossing = find_crossing(*scenario.value().world);
    if (crossing == nullptr) {
      reader_.error(setup_.node.origin,
                    fmt::format("the scenario's world is {}; tests of the crossing are searched",
                                scenario.value().world->kind()));
      return nullptr;
    }
    const auto starts = starts_.space(*crossing, settings_.agents);
    if (!starts || !can_find_defects(scenario.value())) return nullptr;
    auto model = std::make_shared<CrossingModel>(
        settings_, std::make_shared<const CrossingSpace>(dimensions_, name, *starts),
        defect_names(scenario.value()));
    if (setup_.untried || tried(*model, std::move(scenario).value())) return model;
    return nullptr;
  }

  void keep_inputs(const Scenario& scenario) {
    const auto keep = [this](const std::vector<SourcePtr>& sources) {
      settings_.inputs.insert(settings_.inputs.end(), sources.begin(), sources.end());
    };
    if (setup_.untried) return keep(scenario.sources);
    Diagnostics ignored;
    const auto prepared = PreparedScenario::prepare(scenario, ignored);
    keep(prepared.ok() ? prepared.value()->inputs() : scenario.sources);
  }

  /// The settings common to all tests.
  [[nodiscard]] std::vector<std::string> fixed_settings() const {
    std::vector<std::string> sets;
    for (const Dimension& each : dimensions_) {
      if (each.words.size() == 1) sets.push_back(fmt::format("{}={}", each.key, each.words[0]));
    }
    return sets;
  }

  bool can_find_defects(const Scenario& scenario) {
    if (settings_.defects.empty()) return true;
    const bool blames = !settings_.assertions.empty();
    if (!blames) {
      reader_.error(setup_.node.origin, "without assertions nothing blames an AV with defects",
                    "'assertions' names a file of them, as assertions/crossing.yaml");
    }
    const bool brakes = scenario.world->vehicle().model != "constant";
    if (!brakes) {
      reader_.error(setup_.node.origin, "the AV is of the model constant: no defect shows in it",
                    "set world.av.model in the scenario to one that brakes");
    }
    return blames && brakes;
  }

  std::vector<std::string> defect_names(const Scenario& scenario) {
    std::vector<std::string> names;
    for (TestedVehicle& vehicle : tested_vehicles(scenario)) names.push_back(vehicle.name);
    names.erase(names.begin());
    return names;
  }

  /// Whether the least and the greatest values make tests that can be run. What is wrong with the
  /// scenario and its programs whatever the values is reported with its own places.
  bool tried(const CrossingModel& model, Scenario scenario) {
    for (const double value : {-1.0, 1.0}) {
      const TestInput input{Form::vector, std::vector<double>(model.space().dimension(), value)};
      const Outcome outcome = model.make()->run(input, 0);
      if (outcome.executed()) continue;
      Diagnostics warnings;
      auto prepared = PreparedScenario::prepare(std::move(scenario), warnings);
      if (!prepared.ok()) {
        reader_.error_in(setup_.node.origin, prepared.diagnostics());
        return false;
      }
      reader_.error(setup_.node.origin,
                    fmt::format("with the {} values of its parameters a test cannot be run: {}",
                                value < 0 ? "least" : "greatest", outcome.error));
      return false;
    }
    return true;
  }

  const SutSetup& setup_;
  const ConfigReader& reader_;
  CrossingSettings settings_;
  std::vector<Dimension> dimensions_;
  CrossingStartsReader starts_;
  /// Paths of policies, and where they were named.
  std::vector<std::pair<std::string, ValueOrigin>> offered_;
};

}  // namespace

namespace sut::crossing {

std::shared_ptr<const SutModel> read(const SutSetup& setup) { return CrossingReader(setup).read(); }

}  // namespace sut::crossing

}  // namespace jaywalk::search
