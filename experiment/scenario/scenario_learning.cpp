// SPDX-License-Identifier: Apache-2.0
// The keys `learning` (how agents learn) and `policy` (learned policies) of a scenario.

#include <set>

#include "experiment/policy/learner.h"
#include "experiment/scenario/scenario_schema.h"

namespace jaywalk {
namespace {

constexpr NumberRange kWeight{-1e6, 1e6};
constexpr NumberRange kShare{0, 1};
constexpr NumberRange kRate{1e-6, 1};
constexpr NumberRange kWidth{1e-6, 1e6};
constexpr NumberRange kEpisodes{1, 1e9};
constexpr NumberRange kClip{0.01, 10};
constexpr IntegerRange kUnits{1, 1024};
constexpr IntegerRange kPasses{1, 1000};
constexpr IntegerRange kGeneration{1, 1'000'000};

class LearningReader : LayerPart {
 public:
  LearningReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : LayerPart(folder, draft, diagnostics) {}

  void read(const ConfigNode& node, const std::string& path) {
    std::vector<ConfigKey> keys{
        {"learner", [this](const ConfigNode& value, const std::string&) { read_learner(value); }},
        {"reward",
         [this](const ConfigNode& value, const std::string& own) { read_reward(value, own); }},
        {"shared", choice(spec().is_shared, {{"true", true}, {"false", false}})},
        {"discount", number(spec().discount, kShare)},
        {"generation", integer(spec().generation, kGeneration)}};
    for (const LearnerKind& kind : learner_kinds()) {
      keys.push_back({kind.name, [this, &kind](const ConfigNode& value, const std::string& own) {
                        read_settings(value, own, draft_.learner_settings[std::string(kind.name)]);
                      }});
    }
    draft_.scenario.origins[path] = node.origin;
    reader_.read_map(node, path, keys);
  }

  void read_policies(const ConfigNode& node, const std::string& path) {
    draft_.scenario.origins[path] = node.origin;
    draft_.policy_files.clear();
    const auto read_one = [this](const ConfigNode& item) {
      if (const auto file = reader_.text(item, "the path of a policy")) {
        draft_.policy_files.emplace_back(path_in(folder_, *file), item.origin);
      }
    };
    if (node.kind != ConfigNode::Kind::list) return read_one(node);
    for (const ConfigNode& item : node.items) read_one(item);
  }

 private:
  [[nodiscard]] LearningSpec& spec() { return draft_.scenario.learning; }

  void read_learner(const ConfigNode& node) {
    std::vector<Choice<std::string>> choices;
    for (const LearnerKind& kind : learner_kinds()) {
      choices.push_back({kind.name, std::string(kind.name)});
    }
    if (const auto name = reader_.choice(node, std::span<const Choice<std::string>>(choices))) {
      spec().learner = *name;
    }
  }

  // A reward in a file replaces the whole default; an option changes only the terms that it names.
  void read_reward(const ConfigNode& node, const std::string& path) {
    RewardTerms& reward = spec().reward;
    if (node.origin.option.empty()) reward = {};
    const auto weights = [this](auto& target) {
      return [this, &target](const ConfigNode& value, const std::string& own) {
        read_weights(value, own, target);
      };
    };
    read_keys(node, path,
              {
                  {"score", number(reward.score, kWeight)},
                  {"precondition", number(reward.precondition, kWeight)},
                  {"violation", weights(reward.violation)},
                  {"robustness", weights(reward.robustness)},
                  {"new_bins", number(reward.new_bins, kWeight)},
                  {"natural_steps", number(reward.natural_steps, kWeight)},
              });
  }

  void read_weights(const ConfigNode& node, const std::string& path,
                    std::vector<std::pair<std::string, double>>& weights) {
    draft_.scenario.origins[path] = node.origin;
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "assertions' ids and weights, {avoidability: 100}");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      const auto weight = reader_.number(entry.value, kWeight);
      if (!weight) continue;
      draft_.rewarded.emplace_back(entry.key, entry.origin);
      std::erase_if(weights, [&](const auto& known) { return known.first == entry.key; });
      weights.emplace_back(entry.key, *weight);
    }
  }

  void read_settings(const ConfigNode& node, const std::string& path, LearnerSettings& settings) {
    read_keys(node, path,
              {
                  {"bins",
                   [this, &settings](const ConfigNode& value, const std::string& own) {
                     read_list<double>(value, own, "a list of widths, [2, 1]", settings.bins,
                                       [this](const ConfigNode& item, double& width) {
                                         width = reader_.number(item, kWidth).value_or(1);
                                       });
                   }},
                  {"trace", number(settings.trace, kShare)},
                  {"rate", optional_number(settings.rate, kRate)},
                  {"explores", number(settings.explores, kShare)},
                  {"explores_least", number(settings.explores_least, kShare)},
                  {"halves_after", number(settings.halves_after, kEpisodes)},
                  {"hidden", integer(settings.hidden, kUnits)},
                  {"passes", integer(settings.passes, kPasses)},
                  {"clip", number(settings.clip, kClip)},
                  {"entropy", number(settings.entropy, kShare)},
                  {"entropy_least", number(settings.entropy_least, kShare)},
              });
  }
};

}  // namespace

void read_learning(const ConfigNode& node, const std::string& path, const std::string& folder,
                   ScenarioDraft& draft, Diagnostics& diagnostics) {
  LearningReader(folder, draft, diagnostics).read(node, path);
}

void read_policies(const ConfigNode& node, const std::string& path, const std::string& folder,
                   ScenarioDraft& draft, Diagnostics& diagnostics) {
  LearningReader(folder, draft, diagnostics).read_policies(node, path);
}

}  // namespace jaywalk
