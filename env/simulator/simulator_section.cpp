// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/simulator_section.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "env/config/parameter_settings.h"
#include "env/simulator/simulator.h"

namespace jaywalk {
namespace {

constexpr NumberRange kStep{0.001, 3600};

class SimulatorReader : SectionReader {
 public:
  SimulatorReader(const SectionContext& context, SimulatorParameters& parameters)
      : SectionReader(context), parameters_(parameters) {}

  void read(const ConfigNode& node, const std::string& path) {
    note_origin(node, path);
    if (node.kind == ConfigNode::Kind::scalar) return read_name(node);
    if (const ConfigNode* const name = node.find("name")) read_name(*name);
    const SimulatorKind* const kind = find_simulator(parameters_.name);
    if (node.kind == ConfigNode::Kind::map && kind == nullptr) {
      // A wrong name has been reported.
      if (node.find("name") == nullptr) {
        reader_.error(node.origin, "the key 'name' is missing: which simulator?");
      }
      return;
    }
    std::vector<ConfigKey> keys{
        {"name", [](const ConfigNode&, const std::string&) {}},
        {"step", number(parameters_.step_s, kStep)},
    };
    for (const SettingKey& key : kind == nullptr ? std::span<const SettingKey>() : kind->keys) {
      keys.push_back({key.name, [this, &key](const ConfigNode& value, const std::string& where) {
                        note_origin(value, where);
                        read_setting(key, value);
                      }});
    }
    reader_.read_map(node, path, keys);
  }

 private:
  // Another simulator has other keys; `none` is the world by itself.
  void read_name(const ConfigNode& node) {
    const std::optional<std::string> name = reader_.text(node, "the name of a simulator");
    if (!name || *name == parameters_.name) return;
    std::vector<std::string> names{"none"};
    for (const SimulatorKind& kind : simulator_kinds()) names.emplace_back(kind.name);
    if (std::ranges::find(names, *name) == names.end()) {
      reader_.error(node.origin, fmt::format("unknown simulator '{}'", *name),
                    did_you_mean(*name, names));
      return;
    }
    parameters_ = {};
    if (*name != "none") parameters_.name = *name;
  }

  void read_setting(const SettingKey& key, const ConfigNode& node) {
    SettingValue value;
    // A map changes single values of an earlier layer.
    const SettingValue* const before = parameters_.find(key.name);
    if (before != nullptr && key.kind == SettingKind::map) value = *before;
    if (read_value(key, node, value)) {
      parameters_.settings.insert_or_assign(std::string(key.name), std::move(value));
    }
  }

  bool read_value(const SettingKey& key, const ConfigNode& node, SettingValue& value) {
    switch (key.kind) {
      case SettingKind::number:
        return keep(reader_.number(node, {key.least, key.most}), value.number);
      case SettingKind::text:
        return keep(reader_.text(node, key.meaning), value.text);
      case SettingKind::choice:
        return read_choice(key, node, value);
      case SettingKind::flag: {
        static constexpr std::array<Choice<bool>, 2> kWords{{{"true", true}, {"false", false}}};
        return keep(reader_.choice(node, std::span<const Choice<bool>>(kWords)), value.number);
      }
      case SettingKind::file:
        return read_file(node, value);
      case SettingKind::command:
        return keep(read_command_words(node, context_, reader_), value.command);
      case SettingKind::map:
        value.maps.resize(1);
        return read_map(node, value.maps.front());
      case SettingKind::list:
        return read_maps(node, value);
    }
    return false;
  }

  template <class From, class To>
  static bool keep(std::optional<From> found, To& target) {
    if (!found) return false;
    target = static_cast<To>(*std::move(found));
    return true;
  }

  bool read_choice(const SettingKey& key, const ConfigNode& node, SettingValue& value) {
    std::vector<Choice<std::string_view>> words;
    for (std::string_view rest = key.words; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      words.push_back({rest.substr(0, end), rest.substr(0, end)});
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return keep(reader_.choice(node, std::span<const Choice<std::string_view>>(words)), value.text);
  }

  // Its place, as a command of one word, so that stores keep its text as they do a program's.
  bool read_file(const ConfigNode& node, SettingValue& value) {
    const std::optional<std::string> name = reader_.text(node, "the path of a file");
    if (!name) return false;
    value.text = path_in(context_.folder, *name);
    std::error_code ignored;
    if (!context_.files.has(value.text) && !std::filesystem::is_regular_file(value.text, ignored)) {
      reader_.error(node.origin, fmt::format("no file is at '{}'", value.text));
      return false;
    }
    value.command = {value.text};
    return true;
  }

  bool read_map(const ConfigNode& node, std::map<std::string, std::string>& map) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "names and values, {tau: 1}");
      return false;
    }
    for (const ConfigEntry& entry : node.entries) {
      const auto text = reader_.text(entry.value, "a number or a word");
      if (!text) return false;
      map[entry.key] = *text;
    }
    return true;
  }

  bool read_maps(const ConfigNode& node, SettingValue& value) {
    if (node.kind != ConfigNode::Kind::list || node.items.size() > kMaxItems) {
      reader_.unexpected(node, "a list of names and values, [{every: 10}]");
      return false;
    }
    return std::ranges::all_of(node.items, [&](const ConfigNode& item) {
      return read_map(item, value.maps.emplace_back());
    });
  }

  SimulatorParameters& parameters_;
};

}  // namespace

void read_simulator(const ConfigNode& node, const std::string& path, const SectionContext& context,
                    SimulatorParameters& parameters) {
  SimulatorReader(context, parameters).read(node, path);
}

void report_settings(std::vector<SettingProblem> problems, const ValueOrigins& origins,
                     const std::string& scenario, Diagnostics& diagnostics) {
  for (SettingProblem& problem : problems) {
    const std::string path = problem.of_world ? "world" : "world.simulator";
    const std::string key = problem.key.empty() ? path : path + "." + problem.key;
    report(diagnostics, origin_of(origins, key, scenario), std::move(problem.message),
           std::move(problem.hint));
  }
}

void check_simulator(const SimulatorParameters& parameters, const SimulatedSite* site,
                     const std::string& scenario, const SectionContext& context) {
  report_settings(find_simulator(parameters.name)->check(parameters, site), context.origins,
                  scenario, context.diagnostics);
}

}  // namespace jaywalk
