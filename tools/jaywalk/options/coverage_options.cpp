// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/coverage_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

std::string render(const std::string& path, const SourceCoverage& coverage,
                   const std::string& subject) {
  if (path.ends_with(".html")) return coverage_html(coverage, subject);
  if (path.ends_with(".info")) return coverage_lcov(coverage);
  return coverage_text(coverage);
}

}  // namespace

void check_coverage_options(const Arguments& arguments, Diagnostics& diagnostics) {
  for (const std::string& path : arguments.texts(option::kCoverage)) {
    if (path.ends_with(".html") || path.ends_with(".info") || path.ends_with(".txt")) continue;
    diagnostics.error(option::kCoverage.dashed(),
                      fmt::format("expected a file .txt, .html or .info, found '{}'", path));
  }
}

bool write_coverage(const Arguments& arguments, const SourceCoverage& coverage,
                    const std::string& subject, Console& console) {
  bool written = true;
  for (const std::string& path : arguments.texts(option::kCoverage)) {
    written = write_output(path, render(path, coverage, subject), console) && written;
  }
  return written;
}

std::string coverage_subject(const ExperimentDescription& experiment,
                             const CoverageWanted& wanted) {
  std::vector<std::string> behaviours;
  for (const StoredBehaviour& behaviour : experiment.behaviours) {
    if (wanted.behaviour.value_or(behaviour.name) == behaviour.name) {
      behaviours.push_back(behaviour.name);
    }
  }
  const auto agents = wanted.agents ? std::vector{*wanted.agents} : experiment.agents;
  return fmt::format(
      "{}: {}; {} {}; tests {} to {} of seed {}", experiment.scenario, fmt::join(behaviours, ", "),
      fmt::join(agents, ", "), agents == std::vector<std::uint32_t>{1} ? "agent" : "agents",
      experiment.first_test, experiment.first_test + experiment.tests - 1, experiment.seed);
}

}  // namespace jaywalk
