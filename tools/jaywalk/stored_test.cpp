#include "tools/jaywalk/stored_test.h"

#include <fmt/format.h>

namespace jaywalk {

std::unique_ptr<ResultsReader> open_results(const Arguments& arguments, std::string_view command,
                                            Console& console) {
  if (arguments.operands().size() != 1) {
    console.error(fmt::format("expected one store, found {}", arguments.operands().size()),
                  fmt::format("jaywalk {} --help shows how to write it", command));
    return nullptr;
  }
  auto store = ResultsReader::open(arguments.operands().front());
  if (store.ok()) return std::move(store).value();
  console.report(store.diagnostics());
  return nullptr;
}

std::optional<StoredTest> find_stored_test(const ResultsReader& store, const Arguments& arguments,
                                           Console& console) {
  Diagnostics diagnostics;
  const auto number = arguments.number("test", 0, diagnostics);
  const auto agents = arguments.number("agents", 1, diagnostics);
  const auto behaviour = arguments.text("behaviour");
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  TestFilter filter;
  if (!number) filter.succeeded = true;
  const auto tests = store.tests(filter);
  if (!tests.ok()) {
    console.report(tests.diagnostics());
    return std::nullopt;
  }
  for (const StoredTest& each : tests.value()) {
    const std::string& name = store.description().behaviours[each.test.behaviour].name;
    if (number.value_or(each.test.number) == each.test.number &&
        agents.value_or(each.test.agents) == each.test.agents && behaviour.value_or(name) == name) {
      return each;
    }
  }
  console.error("the store has no such test", "without --test, one that met the precondition");
  return std::nullopt;
}

}  // namespace jaywalk
