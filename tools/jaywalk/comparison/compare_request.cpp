#include "tools/jaywalk/comparison/compare_request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/compare/carry_over.h"
#include "experiment/scenario/number_list.h"
#include "experiment/test_run/simulator_version.h"
#include "experiment/test_run/test_run.h"
#include "experiment/test_run/tested_vehicles.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/usual_options.h"

namespace jaywalk::command::compare {
namespace {

/// The options that can be read without the scenario, so that all their errors are reported at
/// once.
struct Options {
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> tests;
  unsigned threads = 1;
  std::optional<std::vector<std::uint32_t>> agents;
  std::vector<FailureCondition> conditions;
  std::optional<StoreOptions> store;
  std::vector<std::string> limits;
};

Options read_options(const Arguments& arguments, Diagnostics& diagnostics) {
  Options options;
  options.seed = arguments.number(option::kSeed, 0, diagnostics);
  options.tests = arguments.number(option::kTests, 1, diagnostics, kMaxTests);
  options.threads = read_threads(arguments, diagnostics);
  if (const auto text = arguments.text(option::kAgents)) {
    auto list = parse_number_list(*text, option::kAgents.dashed());
    if (list) {
      options.agents = std::move(list).value();
    } else {
      diagnostics.append(std::move(list.diagnostics()));
    }
  }
  options.conditions = read_conditions(arguments, diagnostics);
  options.limits = limit_sets(arguments, diagnostics);
  options.store = read_store_options(arguments, diagnostics);
  check_coverage_options(arguments, diagnostics);
  check_format(arguments, diagnostics);
  return options;
}

/// Errors that make a search for defects impossible.
void check_defects(const Request& request, Diagnostics& diagnostics) {
  if (request.criteria.assertions.empty()) {
    diagnostics.error(option::kDefects.dashed(), "without assertions nothing blames an AV",
                      "--assertions names a file of them, as scenarios/assertions/crossing.yaml");
  }
  if (request.prepared->world(0).spec().vehicle().model == "constant") {
    diagnostics.error(option::kDefects.dashed(),
                      "the AV is of the model constant: no defect shows in it",
                      "set world.av.model to one that brakes (jaywalk list vehicles)");
  }
  if (request.prepared->scenario().experiment.feedback > 0) {
    diagnostics.error(option::kDefects.dashed(),
                      "what tests cover would reach those with other AVs",
                      "experiment.feedback=0 runs them without that");
  }
  if (request.plan.order == TestOrder::chained) {
    diagnostics.error(option::kDefects.dashed(),
                      "each test of this scenario needs the one before it",
                      "set world.av.carry_over=false");
  }
}

/// Errors that make a comparison of models of the AV impossible.
void check_avs(const Request& request, Diagnostics& diagnostics) {
  const ExperimentSpec& experiment = request.prepared->scenario().experiment;
  if (!experiment.defects.empty()) {
    diagnostics.error(option::kAvs.dashed(), "models and defects cannot be compared at once",
                      "leave out one of experiment.avs and experiment.defects");
  }
  if (experiment.feedback > 0) {
    diagnostics.error(option::kAvs.dashed(), "what tests cover would reach those with other AVs",
                      "experiment.feedback=0 runs them without that");
  }
  if (request.plan.order == TestOrder::chained) {
    diagnostics.error(option::kAvs.dashed(), "each test of this scenario needs the one before it",
                      "set world.av.carry_over=false");
  }
}

/// Errors about numbers that are too large to be carried out.
Diagnostics excesses(const Request& request) {
  Diagnostics diagnostics;
  if (request.plan.tests > kMaxTests) {  // the scenario's
    diagnostics.error("experiment.tests",
                      fmt::format("at most {}, found {}", kMaxTests, request.plan.tests));
  }
  const bool is_part = request.store && request.store->shard.count > 1;
  if (is_part && request.prepared->scenario().experiment.feedback > 0) {
    diagnostics.error(option::kShard.dashed(),
                      "the tests of a part need what the other parts' tests cover",
                      "experiment.feedback=0 runs them without that");
  }
  if (is_part && request.plan.order == TestOrder::chained) {
    diagnostics.error(option::kShard.dashed(), "each test of this scenario needs the one before it",
                      "share out behaviours and numbers of agents instead (--behaviours, "
                      "--agents), or set world.av.carry_over=false");
  }
  const bool models = compares_models(request.plan.vehicles);
  if (models) check_avs(request, diagnostics);
  if (request.plan.vehicles.size() > 1 && !models) {
    check_defects(request, diagnostics);
  } else {
    for (const OptionName option : request.pointless) {
      diagnostics.error(option.dashed(), "has no meaning without defects",
                        "--defects names them, or all; jaywalk list defects shows them");
    }
  }
  return diagnostics;
}

/// Why some test cannot be run (there are no start cells for it, say); empty if all can.
std::string first_obstacle(const Request& request) {
  for (const std::uint32_t agents : request.plan.agents) {
    for (std::uint64_t test = 0; test < request.plan.tests; ++test) {
      // Obstacles are the same for all behaviours, and only given starts can be too few.
      std::string why =
          problem(*request.prepared, {.agents = agents, .seed = request.seed, .test = test});
      if (!why.empty() || !request.prepared->scenario().world->has_given_starts()) return why;
    }
  }
  return {};
}

/// Whether agents start in cells, where nothing keeps tests from being run.
bool has_cells(const Request& request) {
  const TestSetup first{.agents = request.plan.agents.front(), .seed = request.seed, .test = 0};
  return !start_cells(request.prepared->scenario(), first).empty();
}

/// Reads the kills of other files; false after reporting errors in them.
bool read_other_kills(const Arguments& arguments, Request& request, Console& console) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 26U;
  Diagnostics diagnostics;
  for (const std::string& path : arguments.texts(option::kWithKills)) {
    const auto source = read_source(path, kMostBytes);
    auto lines = source.ok() ? parse_kills(source.value())
                             : Result<std::vector<KillLine>>(source.diagnostics());
    if (!lines.ok()) {
      diagnostics.append(lines.diagnostics());
      continue;
    }
    diagnostics.append(mistakes_of(lines.value(), request.plan, request.other_kills));
    request.other_kills.insert(request.other_kills.end(), lines.value().begin(),
                               lines.value().end());
  }
  console.report(diagnostics);
  if (diagnostics.has_errors()) return false;
  const auto others = other_defects(request.other_kills, request.plan);
  if (!others.empty() && request.plan.vehicles.size() > 1) {
    console.note(fmt::format("--with-kills: left out are defects that are not looked for here: {}",
                             fmt::join(others, ", ")));
  }
  return true;
}

ExperimentDescription describe_experiment(const Request& request, const Arguments& arguments) {
  ExperimentDescription description =
      describe(*request.prepared,
               scenario_options(arguments, listed(arguments, option::kBehaviours), request.limits),
               request.plan, request.seed);
  add_judging(description, request.criteria.files, request.criteria.metrics);
  make_portable(description, request.prepared->scenario().files);
  description.simulator = request.simulator;
  return description;
}

}  // namespace

std::optional<Request> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  const auto file = only_input(arguments, "compare", "scenario", kScenarios, diagnostics);
  const Options options = read_options(arguments, diagnostics);
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  Request request{
      .prepared = prepare_scenario(*file, arguments, listed(arguments, option::kBehaviours),
                                   console, options.limits),
      .limits = options.limits,
      .conditions = options.conditions,
      .store = options.store};
  if (!request.prepared) return std::nullopt;
  const ExperimentSpec& defaults = request.prepared->scenario().experiment;
  request.seed = options.seed.value_or(defaults.seed);
  request.plan.agents = options.agents.value_or(defaults.agents);
  request.plan.tests = options.tests.value_or(defaults.tests);
  request.plan.threads = options.threads;
  request.plan.order = test_order(request.prepared->scenario());
  request.plan.vehicles = request.prepared->vehicles();
  for (const PreparedBehaviour& behaviour : request.prepared->behaviours()) {
    request.plan.behaviours.push_back(behaviour.name);
  }
  auto criteria = read_criteria(arguments, request.prepared->scenario().assertions, console);
  if (!criteria || !check_conditions(request.conditions, *criteria, console)) return std::nullopt;
  request.criteria = std::move(*criteria);
  request.ground = request.prepared->scenario().world->ground();
  auto simulator = simulator_version(request.prepared->scenario());
  if (!simulator.ok()) {
    console.report(simulator.diagnostics());
    return std::nullopt;
  }
  request.simulator = std::move(simulator).value();
  if (arguments.has(option::kCoverage)) {
    const std::uint32_t most = std::ranges::max(request.plan.agents);
    request.coverage =
        std::make_unique<PlanCoverage>(*request.prepared, all_behaviours(*request.prepared, most));
  }
  const bool has_defects =
      request.plan.vehicles.size() > 1 && !compares_models(request.plan.vehicles);
  if (has_defects && !read_other_kills(arguments, request, console)) return std::nullopt;
  for (const OptionName option : {option::kKills, option::kWithKills}) {
    if (!has_defects && arguments.has(option)) request.pointless.push_back(option);
  }
  request.per_test = arguments.has(option::kPerTest);
  request.writes_starts = arguments.has(option::kStarts);
  request.situations = arguments.has(option::kSituations) || defaults.feedback > 0;
  request.description = describe_experiment(request, arguments);
  return request;
}

bool can_be_run(const Request& request, Console& console) {
  if (const Diagnostics wrong = excesses(request); wrong.has_errors()) {
    console.report(wrong);
    return false;
  }
  const std::string why = first_obstacle(request);
  if (!why.empty()) {
    console.error(why);
    return false;
  }
  if (!request.writes_starts || has_cells(request)) return true;
  Diagnostics diagnostics;
  diagnostics.error(option::kStarts.dashed(), "agents of this world do not start in cells",
                    "it is for worlds with a grid, as that of scenarios/paper.yaml");
  console.report(diagnostics);
  return false;
}

}  // namespace jaywalk::command::compare
