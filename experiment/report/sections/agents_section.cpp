// SPDX-License-Identifier: Apache-2.0
// The section of failures: tests that ended errored, dropped intentions, pedestrians that never
// acted.

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "experiment/report/tables/tables.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

constexpr std::size_t kMostCausesListed = 20;

std::string place_cell(const DropCause& cause) {
  if (cause.line == 0) return "–";
  return fmt::format("<code>{}:{}:{}</code>", escaped(cause.file), cause.line, cause.column);
}

void add_causes(Table& table, const BehaviourTroubles& each) {
  table.heading(
      fmt::format("{}: {}", each.behaviour, fmt::join(trouble_sentences(each.troubles), "; ")));
  const std::vector<SharedError>& errors = each.troubles.errors;
  for (std::size_t i = 0; i < std::min(kMostCausesListed, errors.size()); ++i) {
    table.row({"–", "–", "test errored", "–", "–", escaped(errors[i].message),
               fmt::format("{}, the first is {}", plural(errors[i].tests, "test"),
                           errors[i].first_test)});
  }
  const std::vector<SharedCause>& causes = each.troubles.causes;
  for (std::size_t i = 0; i < std::min(kMostCausesListed, causes.size()); ++i) {
    const auto& [cause, agents] = causes[i];
    table.row({grouped(agents), grouped(cause.times), escaped(cause.error), place_cell(cause),
               fmt::format("<code>{}</code>", escaped(cause.formula)), escaped(cause.message),
               escaped(cause.goals)});
  }
}

}  // namespace

std::string section::agents(const ReportData& data) {
  const std::vector<BehaviourTroubles> behaviours = troubles_of(data.comparison);
  if (behaviours.empty()) return {};
  Table table;
  table.columns({"agents", "times"});
  table.columns({"error", "place", "formula", "message", "goals"}, Align::left);
  for (const BehaviourTroubles& each : behaviours) add_causes(table, each);
  return paragraph(
             "Agents of all tests together, each counted once in every test. An intention is "
             "dropped when a formula fails, or a goal has no plan, and no plan is for that "
             "failure. A test is errored if it came to no end of its own; the measures are of the "
             "others.") +
         table.html();
}

}  // namespace jaywalk::reporting
