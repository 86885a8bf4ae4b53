// SPDX-License-Identifier: Apache-2.0
// How to get the same results again: command, seed, versions, hashes of every input.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

std::string compare_command(const ReportData& data) {
  const ExperimentDescription& description = data.description;
  std::string command = fmt::format("jaywalk compare {} --seed {} --tests {} --agents {}",
                                    shell_quoted(description.scenario), description.seed,
                                    description.tests, fmt::join(description.agents, ","));
  if (description.preset) command += " --preset " + shell_quoted(*description.preset);
  for (const std::string& set : description.sets) command += " --set " + shell_quoted(set);
  if (!description.behaviour_options.empty()) {
    command += " --behaviours " +
               shell_quoted(fmt::format("{}", fmt::join(description.behaviour_options, ",")));
  }
  for (const std::string& file : description.assertion_files) {
    command += " --assertions " + shell_quoted(file);
  }
  if (description.metrics) command += " --metrics";
  if (description.shard.count > 1) {
    command += fmt::format(" --shard {}/{}", description.shard.index, description.shard.count);
  }
  if (!data.store_path.empty()) {
    command += fmt::format(" --store again.gpkg --store-level {}", name(description.level));
  }
  return command;
}

std::string inputs(const ExperimentDescription& description) {
  Table table;
  table.column("file", Align::left);
  table.column("bytes");
  table.column("SHA-256", Align::left);
  for (const StoredInput& input : description.inputs) {
    table.row({fmt::format("<code>{}</code>", escaped(input.path)), grouped(input.text.size()),
               fmt::format("<code>{}</code>", escaped(input.sha256))});
  }
  return table.html();
}

}  // namespace

std::string section::reproduce(const ReportData& data) {
  const ExperimentDescription& description = data.description;
  std::string html = paragraph(fmt::format(
      "Made by jaywalk {}. Each test derives from the seed, its number and the number of agents "
      "alone, so the command gives the same results, byte for byte but for measured times, with "
      "any "
      "number of threads:",
      escaped(description.version)));
  html += fmt::format("<pre>{}</pre>\n", escaped(compare_command(data)));
  if (!description.simulator.empty()) {
    html += paragraph(fmt::format("The vehicles were moved by the simulator {}.",
                                  escaped(description.simulator)));
  }
  if (!data.store_path.empty()) {
    html += paragraph(
        "The store has the texts of all files, so that any of its tests runs again from it alone:");
    html += fmt::format("<pre>jaywalk replay {0} --test N\njaywalk report {0}</pre>\n",
                        escaped(shell_quoted(data.store_path)));
  }
  html += paragraph("The files that the tests were made from:");
  return html + inputs(description);
}

}  // namespace jaywalk::reporting
