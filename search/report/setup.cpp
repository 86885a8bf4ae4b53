// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/html.h"
#include "interpreter/support/markup.h"
#include "search/report/search_page.h"

namespace jaywalk::search {
namespace {

using reporting::plural;
using reporting::term;

std::string sut_terms(const SutModel& model) {
  std::string html;
  for (const SutSetting& each : model.settings()) html += term(each.name, escaped(each.value));
  return html;
}

/// The generator's parameters that differ from the defaults, and its cost.
std::string generator_text(const SearchPlan& plan, const GeneratorSpec& spec) {
  std::vector<std::string> parts;
  if (spec.name != spec.kind->name) parts.push_back(std::string(spec.kind->name));
  for (std::size_t i = 0; i < spec.values.size(); ++i) {
    const NumberParameter& parameter = spec.kind->parameters[i];
    if (spec.values[i] == parameter.value) continue;
    parts.push_back(fmt::format("{} {:.6g}", parameter.name, spec.values[i]));
  }
  if (const double cost = plan.generation_s(spec); cost > 0) {
    parts.push_back(fmt::format("{:.6g} s for generating a test", cost));
  }
  return parts.empty() ? spec.name : fmt::format("{} ({})", spec.name, fmt::join(parts, ", "));
}

std::string budget_text(const Budget& budget) {
  std::vector<std::string> parts;
  if (budget.virtual_s > 0) {
    parts.push_back(
        fmt::format("{:.6g} virtual seconds: for each test the simulated time, {:.6g} s "
                    "of overhead and what generating it costs",
                    budget.virtual_s, budget.overhead_s));
  }
  if (budget.tests > 0) parts.push_back(plural(budget.tests, "test"));
  if (budget.failures > 0) {
    parts.push_back(plural(budget.failures, "failing test"));
  }
  return fmt::format("{} for each search", fmt::join(parts, ", or "));
}

std::string fitness_text(const SearchExperiment& experiment) {
  const Fitness& fitness = experiment.plan.fitness;
  return fmt::format(
      "from a fitness of {:.6g} on; the fitness is {}, {:.6g} becomes 0 and {:.6g} "
      "becomes 1",
      fitness.fails_at, experiment.measure, fitness.harmless, fitness.worst);
}

std::string command(const SearchExperiment& experiment) {
  std::string text = "jaywalk search " + shell_quoted(experiment.name);
  const SearchOptions& options = experiment.options;
  for (const std::string& set : options.sets) text += " --set " + shell_quoted(set);
  if (!options.generators.empty()) {
    text += " --generators " + shell_quoted(fmt::format("{}", fmt::join(options.generators, ",")));
  }
  return text + fmt::format(" --repetitions {} --seed {}", experiment.plan.repetitions,
                            experiment.plan.seed);
}

}  // namespace

std::string setup_html(const SearchExperiment& experiment) {
  const SearchPlan& plan = experiment.plan;
  std::vector<std::string> generators;
  for (const GeneratorSpec& spec : plan.generators)
    generators.push_back(generator_text(plan, spec));
  std::string html = term("system under test", escaped(experiment.sut));
  html += sut_terms(*plan.model);
  html += term("generators", escaped(fmt::format("{}", fmt::join(generators, "; "))));
  html += term("budget", escaped(budget_text(plan.budget)));
  html += term("a test fails", escaped(fitness_text(experiment)));
  html += term("repetitions", std::to_string(plan.repetitions));
  html += term("seed", std::to_string(plan.seed));
  html = reporting::terms(html);
  for (const GeneratorSpec& spec : plan.generators) {
    if (!spec.model) continue;
    html += fmt::format("<h3>The system that {} searches</h3>\n", escaped(spec.name));
    html += reporting::terms(sut_terms(*spec.model));
  }
  return html;
}

std::string reproduce_html(const SearchExperiment& experiment) {
  return reporting::paragraph(fmt::format(
             "Made by jaywalk {}. The command gives the same results with any number of threads, "
             "but for measured times; the last digits may differ on another kind of processor.",
             JAYWALK_VERSION)) +
         fmt::format("<pre>{}</pre>\n", escaped(command(experiment))) +
         reporting::paragraph("The experiment’s file:") +
         fmt::format("<pre>{}</pre>\n", escaped(experiment.text));
}

}  // namespace jaywalk::search
