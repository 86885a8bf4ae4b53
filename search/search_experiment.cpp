// SPDX-License-Identifier: Apache-2.0
#include "search/search_experiment.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "env/config/reader.h"
#include "experiment/scenario/files/portable_names.h"
#include "experiment/scenario/scenario_schema.h"
#include "experiment/scenario/scenario_yaml.h"
#include "interpreter/support/markup.h"
#include "search/suts/suts.h"

namespace jaywalk::search {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
constexpr double kMostSeconds = 1e9;
constexpr std::int64_t kMostTests = 10'000'000;

/// Replaces or adds the values of `layer` in `base`, map by map; an empty map replaces the whole
/// map.
void overlay(ConfigNode& base, const ConfigNode& layer) {
  const bool both_maps = base.kind == ConfigNode::Kind::map && layer.kind == ConfigNode::Kind::map;
  if (!both_maps || layer.entries.empty()) {
    base = layer;
    return;
  }
  for (const ConfigEntry& entry : layer.entries) {
    const auto found = std::ranges::find(base.entries, entry.key, &ConfigEntry::key);
    if (found == base.entries.end()) {
      base.entries.push_back(entry);
    } else {
      overlay(found->value, entry.value);
    }
  }
}

std::vector<std::string> generator_names() {
  std::vector<std::string> names;
  for (const GeneratorKind& kind : generators()) names.emplace_back(kind.name);
  return names;
}

std::vector<double> defaults(const GeneratorKind& kind) {
  std::vector<double> values;
  for (const NumberParameter& parameter : kind.parameters) values.push_back(parameter.value);
  return values;
}

class ExperimentReader {
 public:
  ExperimentReader(SourcePtr source, const SearchOptions& options)
      : source_(std::move(source)), options_(options), reader_(diagnostics_) {}

  Result<SearchExperiment> read() {
    experiment_.name = source_->name();
    experiment_.origin = source_->text();
    experiment_.text = source_->text();
    experiment_.options = options_;
    const std::optional<ConfigNode> root = layers();
    if (!root) return std::move(diagnostics_);
    const std::vector<ConfigKey> keys{
        {"defects",
         [&](const ConfigNode& node, const std::string&) {
           experiment_.defects = read_defect_list(node, reader_);
         }},
        {"sut", [&](const ConfigNode& node, const std::string& path) { read_sut(node, path); }},
        {"fitness",
         [&](const ConfigNode& node, const std::string& path) { read_fitness(node, path); }},
        {"budget",
         [&](const ConfigNode& node, const std::string& path) { read_budget(node, path); }},
        {"generators", [&](const ConfigNode& node, const std::string&) { read_generators(node); }},
        {"repetitions", integer_into(experiment_.plan.repetitions, reader_, {1, kMostRepetitions})},
        {"seed", integer_into(experiment_.plan.seed, reader_, {0, INT64_MAX})},
    };
    reader_.read_map(*root, "", keys);
    if (root->find("sut") == nullptr && root->kind == ConfigNode::Kind::map) {
      diagnostics_.error(source_->name(), "no 'sut' to search",
                         "docs/reference/search.md describes what to write");
    }
    select_generators();
    if (const ConfigNode* defects = root->find("defects")) take_defects(*defects);
    check_policies();
    if (diagnostics_.has_errors()) return std::move(diagnostics_);
    for (const GeneratorSpec& spec : experiment_.plan.generators) {
      keep_inputs(experiment_.plan.model_of(spec));
    }
    if (options_.files.are_on_disk()) make_portable();
    return std::move(experiment_);
  }

 private:
  std::optional<ConfigNode> layers() {
    std::optional<ConfigNode> root = parse_config(source_, diagnostics_);
    if (root && root->kind == ConfigNode::Kind::null) {
      diagnostics_.error(source_->name(), "the experiment is empty",
                         "docs/reference/search.md describes what to write");
    }
    for (const std::string& text : options_.sets) {
      const std::optional<ConfigNode> setting = parse_setting(text, diagnostics_);
      if (setting && root) overlay(*root, *setting);
      experiment_.origin += fmt::format("\n--set {}", text);
    }
    if (options_.defects) {
      const std::string text = "defects=" + *options_.defects;
      const auto given = std::make_shared<const Source>("--defects", *options_.defects);
      const std::optional<ConfigNode> setting = parse_setting(text, diagnostics_, given);
      if (setting && root) overlay(*root, *setting);
      experiment_.origin += fmt::format("\n--set {}", text);
    }
    if (diagnostics_.has_errors()) return std::nullopt;
    return root;
  }

  std::shared_ptr<const SutModel> make_sut(const ConfigNode& node, const std::string& path) {
    const ConfigNode* kind = node.find("kind");
    if (kind == nullptr) {
      reader_.error(node.origin, "no 'kind' of the system under test",
                    "`jaywalk list suts` shows them");
      return nullptr;
    }
    std::vector<Choice<const SutKind*>> choices;
    for (const SutKind& each : sut_kinds()) choices.push_back({each.name, &each});
    const auto chosen = reader_.choice<const SutKind*>(*kind, choices);
    if (!chosen) return nullptr;
    if (experiment_.sut.empty()) experiment_.sut = (*chosen)->name;
    const std::string folder = std::filesystem::path(source_->name()).parent_path().string();
    return (*chosen)->read({node, path, reader_, folder, options_.files, options_.include,
                            experiment_.defects, options_.sut_check == SutCheck::omitted,
                            &policies_});
  }

  /// Several generators may search the same system.
  void keep_inputs(const SutModel& model) {
    for (const SourcePtr& input : model.inputs()) {
      const auto same = [&](const SourcePtr& each) { return each->name() == input->name(); };
      if (std::ranges::none_of(experiment_.inputs, same)) experiment_.inputs.push_back(input);
    }
  }

  /// Stores and pages are made from it now, and nothing is read any more.
  void make_portable() {
    std::vector<std::string> names{experiment_.name};
    for (const SourcePtr& input : experiment_.inputs) names.push_back(input->name());
    const PortableNames portable(names, options_.files);
    experiment_.name = portable.in(experiment_.name);
    for (SourcePtr& input : experiment_.inputs) {
      input =
          std::make_shared<const Source>(portable.in(input->name()), std::string(input->text()));
    }
    for (std::string& set : experiment_.options.sets) set = portable.in(std::move(set));
    const std::string options = experiment_.origin.substr(experiment_.text.size());
    experiment_.origin = experiment_.text + portable.in(options);
  }

  void read_sut(const ConfigNode& node, const std::string& path) {
    sut_ = node;
    experiment_.plan.model = make_sut(node, path);
    if (!experiment_.plan.model || experiment_.plan.model->measures().empty()) return;
    choose_measure(0);
  }

  /// With the bounds that it has by itself.
  void choose_measure(std::size_t index) {
    const MeasureKind& kind = experiment_.plan.model->measures()[index];
    experiment_.plan.fitness = {index, kind.harmless, kind.worst, kind.fails_at};
    experiment_.measure = kind.name;
  }

  /// As comparisons do, reports a policy that no behaviour chooses by.
  void check_policies() {
    if (options_.sut_check == SutCheck::omitted) return;
    for (const auto& [path, policy] : policies_) {
      if (policy.is_taken) continue;
      reader_.error(policy.origin,
                    fmt::format("'{}': the policy is for none of the behaviours", path),
                    policy.why_not.empty() ? "none of them has plans that are labelled learned(P)"
                                           : policy.why_not);
    }
  }

  void read_fitness(const ConfigNode& node, const std::string& path) {
    Fitness& fitness = experiment_.plan.fitness;
    const std::vector<ConfigKey> keys{
        {"measure", [&](const ConfigNode& value, const std::string&) { read_measure(value); }},
        {"harmless", number_into(fitness.harmless, reader_, {-1e9, 1e9})},
        {"worst", number_into(fitness.worst, reader_, {-1e9, 1e9})},
        {"fails_at", number_into(fitness.fails_at, reader_, {0, 1})},
    };
    reader_.read_map(node, path, keys);
    if (experiment_.plan.model && !experiment_.plan.model->measures().empty()) check_bounds(node);
    if (fitness.harmless == fitness.worst) {
      reader_.error(node.origin, "'harmless' and 'worst' are the same value");
    }
  }

  void read_measure(const ConfigNode& value) {
    if (!experiment_.plan.model) return;  // reported
    std::vector<Choice<std::size_t>> choices;
    const std::span<const MeasureKind> measures = experiment_.plan.model->measures();
    for (std::size_t i = 0; i < measures.size(); ++i) choices.push_back({measures[i].name, i});
    const auto chosen = reader_.choice<std::size_t>(value, choices);
    if (!chosen) return;
    choose_measure(*chosen);
  }

  /// The unit of a requirement's robustness is the requirement's own: nothing can be assumed.
  void check_bounds(const ConfigNode& node) {
    const auto measures = experiment_.plan.model->measures();
    const std::string_view requirement = measures[experiment_.plan.fitness.measure].requirement;
    const bool is_given = node.find("harmless") != nullptr && node.find("worst") != nullptr;
    if (requirement.empty() || is_given) return;
    reader_.error(node.origin,
                  fmt::format("'{}' needs 'harmless' and 'worst'", experiment_.measure),
                  fmt::format("'{}_scaled' has none", requirement));
  }

  void read_budget(const ConfigNode& node, const std::string& path) {
    Budget& budget = experiment_.plan.budget;
    constexpr NumberRange kSeconds{0, kMostSeconds};
    constexpr IntegerRange kTests{0, kMostTests};
    const std::vector<ConfigKey> keys{
        {"tests", integer_into(budget.tests, reader_, kTests)},
        {"failures", integer_into(budget.failures, reader_, kTests)},
        {"virtual_s", number_into(budget.virtual_s, reader_, kSeconds)},
        {"overhead_s", number_into(budget.overhead_s, reader_, kSeconds)},
        {"generation_s", number_into(budget.generation_s, reader_, kSeconds)},
    };
    reader_.read_map(node, path, keys);
    if (budget.tests == 0 && budget.virtual_s <= 0) {
      reader_.error(node.origin, "nothing bounds the number of tests",
                    "give 'tests' or 'virtual_s' above 0");
    }
  }

  void read_generators(const ConfigNode& node) {
    if (node.kind != ConfigNode::Kind::list || node.items.empty()) {
      reader_.unexpected(node, "a list of generators");
      return;
    }
    for (const ConfigNode& item : node.items) read_generator(item);
  }

  /// A name, or a map with `generator`, perhaps a `name`, other common keys, and the generator's
  /// parameters.
  void read_generator(const ConfigNode& node) {
    const ConfigNode* kind_node = &node;
    if (node.kind == ConfigNode::Kind::map) kind_node = node.find("generator");
    if (kind_node == nullptr) {
      reader_.error(node.origin, "no 'generator' that says which one it is");
      return;
    }
    std::vector<Choice<const GeneratorKind*>> choices;
    for (const GeneratorKind& each : generators()) choices.push_back({each.name, &each});
    const auto kind = reader_.choice<const GeneratorKind*>(*kind_node, choices);
    if (!kind) return;
    GeneratorSpec spec{std::string((*kind)->name), *kind, defaults(**kind)};
    if (node.kind == ConfigNode::Kind::map) read_settings(node, spec);
    const auto& known = experiment_.plan.generators;
    if (std::ranges::find(known, spec.name, &GeneratorSpec::name) != known.end()) {
      reader_.error(node.origin, fmt::format("a second generator with the name '{}'", spec.name),
                    "give one of them a 'name' of its own");
      return;
    }
    experiment_.plan.generators.push_back(std::move(spec));
  }

  void read_settings(const ConfigNode& node, GeneratorSpec& spec) {
    std::vector<ConfigKey> keys{
        {"generator", [](const ConfigNode&, const std::string&) {}},
        {"name",
         [&](const ConfigNode& value, const std::string&) {
           const auto name = reader_.text(value, "a name");
           if (name && !is_identifier(*name)) {
             reader_.error(value.origin,
                           fmt::format("'{}' cannot be the name of a generator", *name),
                           std::string(kIdentifierHint));
           }
           spec.name = name.value_or(spec.name);
         }},
        {"generation_s",
         [&](const ConfigNode& value, const std::string&) {
           spec.generation_s = reader_.number(value, {0, kMostSeconds});
         }},
        {"sut",
         [&](const ConfigNode& value, const std::string& path) {
           ConfigNode changed = sut_;
           overlay(changed, value);
           spec.model = make_sut(changed, path);
           if (spec.model) check_measures(value, *spec.model);
         }},
    };
    for (ConfigKey& key : parameter_keys(spec.kind->parameters, reader_, spec.values)) {
      keys.push_back(std::move(key));
    }
    reader_.read_map(node, "generators", keys);
  }

  /// All SUTs of an experiment measure the same, so that one fitness fits all.
  void check_measures(const ConfigNode& node, const SutModel& model) {
    if (!experiment_.plan.model) return;  // reported
    if (std::ranges::equal(model.measures(), experiment_.plan.model->measures(), {},
                           &MeasureKind::name, &MeasureKind::name)) {
      return;
    }
    reader_.error(node.origin, "this system under test measures other things than 'sut'");
  }

  /// Selects the generators that the options name; all of the table if neither file nor options
  /// name any.
  void select_generators() {
    std::vector<GeneratorSpec>& known = experiment_.plan.generators;
    if (options_.generators.empty()) {
      if (!known.empty() || diagnostics_.has_errors()) return;
      for (const GeneratorKind& kind : generators()) {
        known.push_back({std::string(kind.name), &kind, defaults(kind)});
      }
      return;
    }
    std::vector<GeneratorSpec> selected;
    for (const std::string& wanted : options_.generators) {
      experiment_.origin += fmt::format("\n--generators {}", wanted);
      const auto spec = std::ranges::find(known, wanted, &GeneratorSpec::name);
      const GeneratorKind* kind = find_generator(wanted);
      if (spec != known.end()) {
        selected.push_back(*spec);
      } else if (kind != nullptr) {
        selected.push_back({wanted, kind, defaults(*kind)});
      } else {
        diagnostics_.error(fmt::format("generator {}", wanted), "there is no such generator",
                           did_you_mean(wanted, generator_names()));
      }
    }
    known = std::move(selected);
  }

  /// Each generator becomes as many as there are defects.
  void take_defects(const ConfigNode& node) {
    if (diagnostics_.has_errors() || experiment_.defects.empty()) return;
    std::vector<GeneratorSpec> all;
    for (const GeneratorSpec& spec : experiment_.plan.generators) {
      const SutModel& model = experiment_.plan.model_of(spec);
      const std::vector<std::string> names = model.defects();
      if (names.empty()) {
        reader_.error(
            node.origin,
            fmt::format("the system under test '{}' has no AV with defects", experiment_.sut),
            "that of the kind crossing has");
        return;
      }
      for (std::size_t i = 0; i < names.size(); ++i) {
        GeneratorSpec& each = all.emplace_back(spec);
        each.name = fmt::format("{} {}", spec.name, names[i]);
        each.model = model.with_defect(i);
        each.family = spec.name;
        each.defect = i;
      }
    }
    experiment_.plan.generators = std::move(all);
  }

  SourcePtr source_;
  const SearchOptions& options_;
  Diagnostics diagnostics_;
  ConfigReader reader_;
  OfferedPolicies policies_;
  SearchExperiment experiment_;
  ConfigNode sut_;  // the keys of the experiment's own
};

}  // namespace

Result<SearchExperiment> parse_search(const SourcePtr& source, const SearchOptions& options) {
  return ExperimentReader(source, options).read();
}

Result<SearchExperiment> read_search(const std::string& path, const SearchOptions& options) {
  Result<SourcePtr> source = read_source(path, kMostBytes);
  if (!source.ok()) return std::move(source.diagnostics());
  return parse_search(source.value(), options);
}

bool is_search(const SourcePtr& source) {
  Diagnostics ignored;
  const std::optional<ConfigNode> root = parse_config(source, ignored);
  return root && root->find("sut") != nullptr;
}

}  // namespace jaywalk::search
