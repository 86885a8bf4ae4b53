// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/stored_test.h"

#include <algorithm>

#include <fmt/format.h>

#include "env/vehicle/defects.h"
#include "experiment/compare/kills/kills.h"
#include "experiment/scenario/number_list.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

Commands commands_of(const Arguments& arguments) {
  return arguments.has(option::kAllowCommands) ? Commands::allowed : Commands::refused;
}

std::unique_ptr<ResultsReader> open_results(const Arguments& arguments, std::string_view command,
                                            Console& console) {
  Diagnostics wrong;
  const auto file = only_input(arguments, command, "store", kStores, wrong);
  console.report(wrong);
  if (!file) return nullptr;
  auto store = ResultsReader::open(*file, commands_of(arguments));
  if (store.ok()) return std::move(store).value();
  console.report(store.diagnostics());
  return nullptr;
}

namespace {

/// The vehicle that --defect names; nothing after adding an error.
std::optional<std::size_t> wanted_vehicle(const ResultsReader& store, const Arguments& arguments,
                                          Diagnostics& diagnostics) {
  const auto name = arguments.text(option::kDefect);
  if (!name) return 0;
  const std::vector<std::string>& all = store.description().vehicles;
  const auto parsed = parse_defect(*name);
  const std::string wanted = parsed ? text_of(*parsed) : *name;
  const auto found = std::ranges::find(all, wanted);
  if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
  const auto source = std::make_shared<const Source>(option::kDefect.dashed(), *name);
  diagnostics.error({source, {0, static_cast<std::uint32_t>(name->size())}},
                    fmt::format("no test of the store is with '{}'", wanted),
                    did_you_mean(wanted, all));
  return std::nullopt;
}

/// Whether to choose the test if the options do not name one: it kills, or met the precondition.
bool is_worth_seeing(const ResultsReader& store, const StoredTest& test) {
  if (test.test.vehicle == 0) return test.result.succeeded;
  const auto own = store.assessments(test.id);
  const auto healthy = store.assessments(twin_id(store.description(), test.test));
  return own.ok() && healthy.ok() && blames_the_av(own.value()) && !blames_the_av(healthy.value());
}

}  // namespace

std::optional<StoredTest> find_stored_test(const ResultsReader& store, const Arguments& arguments,
                                           Console& console) {
  Diagnostics diagnostics;
  const auto number = arguments.number(option::kTest, 0, diagnostics);
  const auto agents = arguments.number(option::kAgents, 1, diagnostics, kMaxAgents);
  const auto behaviour = arguments.text(option::kBehaviour);
  const auto vehicle = wanted_vehicle(store, arguments, diagnostics);
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  std::optional<StoredTest> found;
  const auto failure = store.for_each_test({.vehicle = vehicle}, [&](const StoredTest& each) {
    const std::string& name = store.description().behaviours[each.test.behaviour].name;
    if (number.value_or(each.test.number) == each.test.number &&
        agents.value_or(each.test.agents) == each.test.agents && behaviour.value_or(name) == name &&
        (number || is_worth_seeing(store, each))) {
      found = each;
    }
    return found ? Proceed::no : Proceed::yes;
  });
  if (failure) {
    console.report(*failure);
    return std::nullopt;
  }
  if (found) return found;
  const std::string_view worth = vehicle == 0 ? "met the precondition" : "kills the defect";
  if (number) {
    console.error("the store has no such test", fmt::format("without --test, one that {}", worth));
  } else {
    console.error(fmt::format("no such test of the store {}", worth), "--test names another one");
  }
  return std::nullopt;
}

}  // namespace jaywalk
