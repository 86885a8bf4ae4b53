// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/programs/vocabulary.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "env/environments.h"
#include "interpreter/check/checking.h"
#include "interpreter/check/index/program_index.h"
#include "interpreter/check/index/uses.h"
#include "interpreter/compile/kqml_plans.h"
#include "interpreter/logic/action.h"
#include "interpreter/support/containers/lazy.h"
#include "interpreter/support/remarks.h"
#include "interpreter/syntax/parser.h"
#include "tools/jaywalk/options/shipped.h"

namespace jaywalk {
namespace {

Vocabulary::Entry entry_for(const EnvironmentWord& word) {
  return {.name = std::string(functor(word)),
          .least_args = arity(word),
          .most_args = arity(word),
          .summary = description(word),
          .values = argument_values(word)};
}

// Evidence for and against a program being written for an environment.
class Evidence {
 public:
  Evidence(const Vocabulary& vocabulary, const ProgramWords& program)
      : vocabulary_(vocabulary), own_([&program] { return heads_of(program); }) {
    for (const Uses& uses : program.uses) {
      for (const ast::Node* action : uses.actions) this->action(*action, program.index);
      for (const ast::Node* query : uses.queries) percept(*query);
      for (const ast::Plan* plan : uses.plans) {
        if (plan->trigger.kind == ast::TriggerKind::belief) {
          percept(*plan->trigger.literal);
        }
      }
    }
  }

  /// Whether it uses an action of the environment, no action of another one, and also a percept or
  /// value of the environment, since worlds share names of actions.
  [[nodiscard]] bool is_for() const {
    return takes_action_ && !takes_foreign_ && (perceives_ || uses_values_);
  }

 private:
  void action(const ast::Node& node, const ProgramIndex& index) {
    const auto is_known = [&](const Vocabulary::Entry& entry) {
      return entry.name == node.text && takes(entry, arity_of(node));
    };
    const auto known = std::ranges::find_if(vocabulary_.actions, is_known);
    if (known != vocabulary_.actions.end()) {
      takes_action_ = true;
      uses_values_ = uses_values_ || has_value(node, *known);
      return;
    }
    // A slip for one of them, a goal without '!', a belief without '?' or an internal action
    // without its dot says nothing.
    const bool is_slip =
        entry_of(vocabulary_.actions, node.text) != nullptr ||
        !did_you_mean(node.text, names_of(vocabulary_.actions)).empty() ||
        !index.planned_goals.arities(node.text).empty() ||
        !index.beliefs.arities(node.text).empty() ||
        entry_of(vocabulary_.internal_actions, fmt::format(".{}", node.text)) != nullptr;
    takes_foreign_ = takes_foreign_ || !is_slip;
  }

  static bool has_value(const ast::Node& action, const Vocabulary::Entry& entry) {
    for (std::size_t i = 0; i < entry.values.size(); ++i) {
      const std::string_view atom = action.args[i]->text;
      const bool has = std::ranges::any_of(entry.values[i], [&](const std::string& value) {
        return value == atom || is_one_slip(value, atom);
      });
      if (has) return true;
    }
    return false;
  }

  // A name that the program also believes by itself is no evidence of a percept.
  void percept(const ast::Node& node) {
    if (perceives_ || node.kind != ast::Kind::literal) return;
    const Vocabulary::Entry* const known = entry_of(vocabulary_.percepts, node.text);
    perceives_ = known != nullptr && takes(*known, arity_of(node)) && !own_->contains(node.text);
  }

  static std::set<std::string_view> heads_of(const ProgramWords& program) {
    std::set<std::string_view> heads;
    for (const Uses& uses : program.uses) {
      for (const Clause& clause : uses.clauses) heads.insert(clause.head->text);
    }
    return heads;
  }

  const Vocabulary& vocabulary_;
  Lazy<std::set<std::string_view>> own_;
  bool takes_action_ = false;
  bool takes_foreign_ = false;
  bool perceives_ = false;
  bool uses_values_ = false;
};

// The performatives for which every agent has plans.
const std::vector<std::string>& standard_performatives() {
  static const std::vector<std::string> performatives = [] {
    Diagnostics ignored;
    const auto source = std::make_shared<const Source>("kqml", std::string(kKqmlPlans));
    const ast::File file = parse_agent(source, ignored);
    const auto handled = handled_performatives(uses_in(file.components));
    return std::vector<std::string>(handled.begin(), handled.end());
  }();
  return performatives;
}

// An item of `library.defines` and `library.asks` for each name in a file.
Vocabulary::Library read_library(const std::string& name, const SourcePtr& source) {
  Vocabulary::Library library{.name = name, .defines = {}, .asks = {}};
  Diagnostics ignored;
  const ast::File file = parse_agent(source, ignored);
  const Uses uses = uses_in(file.components);
  for (const Clause& clause : uses.clauses) library.defines.insert(belief_name(*clause.head));
  for (const ast::Plan* plan : uses.plans) {
    if (is_for_goal(*plan)) library.defines.insert(goal_name(*plan->trigger.literal));
  }
  for (const Remark& remark : remarks(*source)) {
    if (remark.word == Remark::kAsks) library.asks.emplace(remark.item);
  }
  return library;
}

std::vector<Vocabulary::Library> installed_libraries() {
  std::vector<Vocabulary::Library> libraries;
  const SourceFiles files = files_on_disk();
  for (const EnvironmentKind& environment : environments()) {
    for (const std::string& name :
         files.installed_in(fmt::format("{}{}/shared", kLibraryPrefix, environment.name))) {
      if (const auto source = files.read(name)) {
        libraries.push_back(read_library(name, source.value()));
      }
    }
  }
  return libraries;
}

}  // namespace

Vocabulary vocabulary_for(const EnvironmentKind* environment) {
  Vocabulary vocabulary;
  if (environment != nullptr) {
    vocabulary.environment_known = true;
    std::ranges::transform(environment->percepts, std::back_inserter(vocabulary.percepts),
                           entry_for);
    std::ranges::transform(environment->actions, std::back_inserter(vocabulary.actions), entry_for);
  }
  const auto add = [&vocabulary](const auto& known) {
    vocabulary.internal_actions.push_back(
        {known.name, known.least_args, known.most_args, known.summary});
  };
  std::ranges::for_each(standard_actions().actions(), add);
  std::ranges::for_each(standard_actions().functions(), add);
  for (std::size_t i = standard_actions().actions().size(); i < vocabulary.internal_actions.size();
       ++i) {
    vocabulary.internal_actions[i].is_function = true;
  }
  // The internal actions behind `if`, `for`, `while`, `|&|` and `|||`.
  for (const auto& [name, least, most] :
       {std::tuple{".if_then_else", 2, 3}, {".foreach", 2, 2}, {".loop", 2, 2}, {".fork", 2, -1}}) {
    vocabulary.internal_actions.push_back({name, least, most, "a statement"});
  }
  vocabulary.performatives = standard_performatives();
  vocabulary.libraries = installed_libraries;
  return vocabulary;
}

void add_own_actions(const ActionRegistry& actions, Vocabulary& vocabulary) {
  const auto add = [&vocabulary](const auto& known, bool is_function) {
    if (entry_of(vocabulary.internal_actions, known.name) != nullptr) return;
    vocabulary.internal_actions.push_back(
        {known.name, known.least_args, known.most_args, known.summary});
    vocabulary.internal_actions.back().is_function = is_function;
  };
  for (const ActionDefinition& action : actions.actions()) add(action, false);
  for (const FunctionDefinition& function : actions.functions()) add(function, true);
}

const EnvironmentKind* environment_of(const SourceTree& program) {
  return environment_of(words_of(program));
}

const EnvironmentKind* environment_of(const ProgramWords& words) {
  for (const EnvironmentKind& environment : environments()) {
    const Vocabulary vocabulary = vocabulary_for(&environment);
    if (Evidence(vocabulary, words).is_for()) return &environment;
  }
  return nullptr;
}

void mark_absent_percepts(const Scenario& scenario, Vocabulary& vocabulary) {
  const auto percepts = find_environment(scenario.world->kind())->percepts;
  assert(vocabulary.percepts.size() == percepts.size() && "they are the world's");
  for (const std::size_t i : scenario.world->absent_percepts()) {
    vocabulary.percepts[i].absent_without = percepts[i].needs;
  }
}

namespace {

// The value behind the key of a scenario's line, or the key if it is not there.
SourceSpan place_of_value(const SourceSpan& key, std::string_view value) {
  if (key.source == nullptr) return key;
  const std::string_view text = key.source->text();
  const std::string_view line = text.substr(0, text.find('\n', key.span.end));
  const std::size_t at = line.find(value, key.span.end);
  if (at == line.npos) return key;
  const auto begin = static_cast<std::uint32_t>(at);
  return {key.source, {begin, begin + static_cast<std::uint32_t>(value.size())}};
}

}  // namespace

std::vector<Vocabulary::Setting> settings_of(const Scenario& scenario, const std::string& program) {
  std::vector<Vocabulary::Setting> settings;
  const auto add = [&settings](const std::vector<ParameterSetting>& parameters) {
    for (const ParameterSetting& parameter : parameters) {
      Vocabulary::Setting setting{.name = parameter.name,
                                  .atoms = {},
                                  .where = parameter.origin.where,
                                  .option = parameter.origin.option};
      for (const ParameterValue& value : parameter.values) {
        const auto* const atom = std::get_if<std::string>(&value);
        setting.atoms.push_back(atom == nullptr ? std::string() : *atom);
        if (atom == nullptr || parameter.values.size() > 1) continue;
        setting.where = place_of_value(parameter.origin.where, *atom);
      }
      settings.push_back(std::move(setting));
    }
  };
  for (const auto* behaviours : {&scenario.behaviours, &scenario.actors}) {
    for (const BehaviourSpec& behaviour : *behaviours) {
      if (behaviour.program != program) continue;
      add(behaviour.parameters);
      for (const AgentSettings& own : behaviour.agents) add(own.parameters);
    }
  }
  return settings;
}

}  // namespace jaywalk
