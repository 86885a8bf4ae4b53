#include "tools/jaywalk/scenario_options.h"

#include <map>
#include <utility>

#include "tools/jaywalk/include_path.h"
#include "tools/jaywalk/program_check.h"
#include "tools/jaywalk/shipped.h"

namespace jaywalk {

bool is_scenario_file(const std::string& path) {
  return path.ends_with(".yaml") || path.ends_with(".yml");
}

ScenarioOptions scenario_options(const Arguments& arguments, std::vector<std::string> behaviours) {
  Diagnostics ignored;  // prepare_scenario() reports them
  IncludePath include_path = parse_include_path(arguments, ignored);
  // Programs may be installed ones, as scenarios may.
  for (std::string& behaviour : behaviours) {
    if (behaviour.ends_with(".asl") && !behaviour.starts_with(kLibraryPrefix)) {
      behaviour = located(behaviour);
    }
  }
  std::vector<std::string> sets = arguments.texts("set");
  std::map<std::string, SourcePtr> given_by;
  if (const auto defects = arguments.text("defects")) {
    sets.push_back("experiment.defects=" + *defects);
    given_by[sets.back()] = std::make_shared<const Source>("--defects", *defects);
  }
  return {.preset = arguments.text("preset"),
          .sets = std::move(sets),
          .given_by = std::move(given_by),
          .behaviours = std::move(behaviours),
          .files = std::move(include_path.files),
          .include = {std::move(include_path.folders), std::move(include_path.mapped)}};
}

std::shared_ptr<const PreparedScenario> prepare_scenario(const std::string& path,
                                                         const Arguments& arguments,
                                                         std::vector<std::string> behaviours,
                                                         Console& console) {
  if (!read_include_path(arguments, console)) return nullptr;
  const ScenarioOptions options = scenario_options(arguments, std::move(behaviours));
  Result<Scenario> scenario = read_scenario(path, options);
  if (!scenario) {
    console.report(scenario.diagnostics());
    return nullptr;
  }
  Diagnostics warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  if (!prepared) {
    console.report(warnings);
    console.report(prepared.diagnostics());
    return nullptr;
  }
  if (!arguments.has("no-check")) {
    // They are among what the checker says.
    warnings = {};
    Checked checked;
    const Scenario& own = prepared.value()->scenario();
    check_programs(own, checked, warnings);
  }
  console.report(warnings);
  return std::move(prepared).value();
}

}  // namespace jaywalk
