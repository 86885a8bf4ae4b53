#pragma once

// What the readers of a scenario's parts share: keys are read in a fixed order, and where each was
// given is kept. Read scenario_schema.h before.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "experiment/scenario/scenario_reader.h"
#include "experiment/scenario/scenario_schema.h"

namespace jaywalk {

class LayerPart {
 protected:
  LayerPart(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : folder_(folder), draft_(draft), reader_(diagnostics) {}

  using KeyReader = std::function<void(const ConfigNode&, const std::string&)>;

  // Keeps where the key was given, for what is found to be wrong with it later.
  void read_keys(const ConfigNode& node, const std::string& path,
                 std::initializer_list<ConfigKey> keys) {
    draft_.origins[path] = node.origin;
    reader_.read_map(node, path, {keys.begin(), keys.size()});
  }

  // The handlers of plain values: read, check, store.
  KeyReader number(double& target, NumberRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.number(node, range)) target = *value;
    };
  }
  template <class T>
  KeyReader integer(T& target, IntegerRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.integer(node, range)) target = static_cast<T>(*value);
    };
  }
  KeyReader optional_number(std::optional<double>& target, NumberRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.number(node, range)) target = *value;
    };
  }
  KeyReader interval(Interval& target, IntegerRange range) {
    return [this, &target, range](const ConfigNode& node, const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.interval(node, range)) target = *value;
    };
  }
  template <class T>
  KeyReader choice(T& target, std::initializer_list<Choice<T>> choices) {
    return [this, &target, words = std::vector<Choice<T>>(choices)](const ConfigNode& node,
                                                                    const std::string& path) {
      draft_.origins[path] = node.origin;
      if (const auto value = reader_.choice(node, std::span<const Choice<T>>(words))) {
        target = *value;
      }
    };
  }

  // Each item of a list, which takes the place of what was there.
  template <class Item>
  void read_list(const ConfigNode& node, const std::string& path, std::string_view expected,
                 std::vector<Item>& target, std::function<void(const ConfigNode&, Item&)> read) {
    draft_.origins[path] = node.origin;
    if (node.kind != ConfigNode::Kind::list || node.items.size() > kMaxItems) {
      reader_.unexpected(node, expected);
      return;
    }
    target.clear();
    for (const ConfigNode& item : node.items) read(item, target.emplace_back());
  }

  void require(const ConfigNode& node, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
      if (node.kind == ConfigNode::Kind::map && node.find(key) == nullptr) {
        reader_.error(node.origin, fmt::format("the key '{}' is missing", key));
      }
    }
  }

  [[nodiscard]] CrossingParameters& world() { return draft_.scenario.world; }

  // As many items as a list may have.
  static constexpr std::size_t kMaxItems = 1000;

  const std::string& folder_;
  ScenarioDraft& draft_;
  ConfigReader reader_;
};

/// Reads the value of a key into the draft.
using PartReader = void(const ConfigNode& node, const std::string& path, const std::string& folder,
                        ScenarioDraft& draft, Diagnostics& diagnostics);

/// The key `world` of a layer, and those of its keys that are read in files of their own.
PartReader read_world, read_bands, read_map, read_crosswalks, read_obstacles, read_actors, read_av,
    read_simulator;
/// The keys `learning` and `policy`.
PartReader read_learning, read_policies;

/// A program and its arguments, of which one that is a file beside the scenario is found there.
[[nodiscard]] std::optional<std::vector<std::string>> read_command_words(
    const ConfigNode& node, const std::string& folder, const SourceFiles& files,
    const ConfigReader& reader);

/// Reads `{radius: 15, odds: [1, 11]}`; a name that is there already is given its new values.
void read_parameters(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<ParameterSetting>& settings);

/// A defect of the AV, `latency` or `latency=0.6`; nothing after reporting what is wrong.
[[nodiscard]] std::optional<VehicleDefect> read_defect(const ConfigNode& node,
                                                       const ConfigReader& reader);
/// `all`, which is every defect with each of its severities; or a list, or a text with commas.
[[nodiscard]] std::vector<VehicleDefect> read_defect_list(const ConfigNode& node,
                                                          const ConfigReader& reader);

/// Models of the AV, as a list or a text with commas. Whether they exist is known when the layers
/// are: av_model_names().
[[nodiscard]] std::vector<std::string> read_av_list(const ConfigNode& node,
                                                    const ConfigReader& reader);
/// Those that a simulator has, or without one the world; none if the simulator has no such key.
[[nodiscard]] std::vector<std::string> av_model_names(const SimulatorParameters& simulator);

/// Whether a text can be an atom of AgentSpeak.
[[nodiscard]] bool is_atom(std::string_view text);

}  // namespace jaywalk
