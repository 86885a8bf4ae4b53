#pragma once

// What the readers of a scenario's parts share: keys are read in a fixed order, and where each was
// given is kept. Read scenario_schema.h before.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/scenario_reader.h"
#include "experiment/scenario_schema.h"

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

  const std::string& folder_;
  ScenarioDraft& draft_;
  ConfigReader reader_;
};

/// Reads the key `world` of a layer.
void read_world(const ConfigNode& node, const std::string& path, const std::string& folder,
                ScenarioDraft& draft, Diagnostics& diagnostics);

/// Reads `{radius: 15, odds: [1, 11]}`; a name that is there already is given its new values.
void read_parameters(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<ParameterSetting>& settings);

/// Whether a text can be an atom of AgentSpeak.
[[nodiscard]] bool is_atom(std::string_view text);

}  // namespace jaywalk
