// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "experiment/report/tables/tables.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMostCausesShown = 5;

std::string error_lines(const std::vector<SharedError>& errors) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostCausesShown, errors.size()); ++i) {
    text += fmt::format("    {}, the first is {}: {}\n", counted(errors[i].tests, "test"),
                        errors[i].first_test, errors[i].message);
  }
  if (errors.size() > kMostCausesShown) {
    text += fmt::format("    and {} more errors\n", errors.size() - kMostCausesShown);
  }
  return text;
}

}  // namespace

std::vector<BehaviourTroubles> troubles_of(const Comparison& comparison) {
  std::vector<BehaviourTroubles> found;
  for (std::size_t row = 0; row < comparison.troubles.size();) {
    const std::string& behaviour = comparison.summaries[row].behaviour;
    std::vector<Troubles> parts;
    while (row < comparison.troubles.size() && comparison.summaries[row].behaviour == behaviour) {
      parts.push_back(comparison.troubles[row++]);
    }
    Troubles all = together(parts);
    if (all.dropping > 0 || all.idle > 0 || all.errored > 0)
      found.push_back({behaviour, std::move(all)});
  }
  return found;
}

std::vector<std::string> trouble_sentences(const Troubles& troubles) {
  std::vector<std::string> sentences;
  if (troubles.errored > 0) {
    sentences.push_back(fmt::format("{} ended errored; the measures are of the others",
                                    counted(troubles.errored, "test")));
  }
  if (troubles.never_acted()) {
    sentences.push_back(fmt::format("its agents never acted: no action of {} was carried out",
                                    counted(troubles.pedestrians, "agent")));
  } else if (troubles.idle > 0) {
    sentences.push_back(
        fmt::format("{} of {} never acted", troubles.idle, counted(troubles.pedestrians, "agent")));
  }
  if (troubles.dropping > 0) {
    sentences.push_back(fmt::format("{} of {} dropped an intention", troubles.dropping,
                                    counted(troubles.agents, "agent")));
  }
  return sentences;
}

std::string render_troubles(const std::vector<BehaviourTroubles>& behaviours) {
  if (behaviours.empty()) return {};
  std::string text = "What happened to agents (in all tests together)\n";
  for (const auto& [behaviour, troubles] : behaviours) {
    for (const std::string& sentence : trouble_sentences(troubles)) {
      text += fmt::format("  {}: {}\n", behaviour, sentence);
    }
    text += error_lines(troubles.errors);
    for (std::size_t i = 0; i < std::min(kMostCausesShown, troubles.causes.size()); ++i) {
      const auto& [cause, agents] = troubles.causes[i];
      text += fmt::format("    {}: {}\n", counted(agents, "agent"), describe(cause));
      if (cause.goals.find(" > ") != std::string::npos) {
        text += fmt::format("      goals: {}\n", cause.goals);
      }
    }
    if (troubles.causes.size() > kMostCausesShown) {
      text += fmt::format("    and {} more causes\n", troubles.causes.size() - kMostCausesShown);
    }
  }
  return text;
}

std::uint64_t errored_tests(const Comparison& comparison) {
  std::uint64_t count = 0;
  for (const Summary& summary : comparison.summaries) count += summary.errored;
  return count;
}

bool is_troubled(const std::vector<BehaviourTroubles>& behaviours) {
  return std::ranges::any_of(behaviours, [](const BehaviourTroubles& each) {
    return each.troubles.dropping > 0 || each.troubles.errored > 0 || each.troubles.never_acted();
  });
}

}  // namespace jaywalk
