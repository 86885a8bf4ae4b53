// SPDX-License-Identifier: Apache-2.0
#include "search/search_kills.h"

#include <algorithm>
#include <iterator>

namespace jaywalk::search {

SearchKills::SearchKills(const SearchExperiment& experiment)
    : plan_(experiment.plan),
      defects_(plan_.model_of(plan_.generators.front()).defects().size()),
      counts_(plan_.searches()),
      killers_(plan_.generators.size() / defects_) {}

void SearchKills::add(std::size_t search, const SearchRun& run) {
  const std::size_t place = search / plan_.repetitions;
  const SutModel& model = plan_.model_of(plan_.generators[place]);
  const std::size_t kills = find_measure(model.measures(), "kills").value();
  const std::size_t healthy = find_measure(model.measures(), "healthy_blamed").value();
  Count& count = counts_[search];
  count.complete = run.complete;
  for (const TestRow& row : run.tests) {
    const Outcome& outcome = row.test.outcome;
    if (!outcome.executed()) continue;
    ++count.tests;
    if (outcome.measures[healthy] > 0) ++count.healthy_failures;
    if (outcome.measures[kills] <= 0) continue;
    if (++count.kills == 1) count.first = count.tests;
    const std::scoped_lock lock(mutex_);
    std::vector<bool>& killed = killers_[place / defects_][row.test.input.values];
    killed.resize(defects_);
    killed[plan_.generators[place].defect] = true;
  }
}

KillCell SearchKills::cell_of(std::size_t generator) const {
  KillCell cell;
  std::vector<std::optional<std::uint64_t>> firsts;
  for (std::size_t repetition = 0; repetition < plan_.repetitions; ++repetition) {
    const Count& count = counts_[generator * plan_.repetitions + repetition];
    if (!count.complete) return {};
    if (count.first && !cell.first) cell.first = cell.tests + *count.first;
    cell.tests += count.tests;
    cell.kills += count.kills;
    firsts.push_back(count.first);
  }
  // The lower one of two in the middle; none is longer than any.
  const auto middle = firsts.begin() + static_cast<std::ptrdiff_t>((firsts.size() - 1) / 2);
  std::ranges::nth_element(firsts, middle,
                           [](const auto& a, const auto& b) { return a && (!b || *a < *b); });
  cell.measured = KillCell::Measured{*middle};
  return cell;
}

std::vector<SearchKills::Team> SearchKills::best_tests(std::size_t generator) const {
  // One test of each set that kills the same defects.
  std::map<std::vector<bool>, const std::vector<double>*> kinds;
  for (const auto& [values, killed] : killers_[generator]) kinds.emplace(killed, &values);
  const auto count = [](const std::vector<bool>& killed) {
    return static_cast<std::size_t>(std::ranges::count(killed, true));
  };
  Team one;
  Team two;
  for (auto first = kinds.begin(); first != kinds.end(); ++first) {
    const std::size_t alone = count(first->first);
    if (alone > one.killed) one = {{{Form::vector, *first->second}}, alone};
    for (auto second = std::next(first); second != kinds.end(); ++second) {
      std::vector<bool> both = first->first;
      for (std::size_t i = 0; i < defects_; ++i) both[i] = both[i] || second->first[i];
      const std::size_t together = count(both);
      if (together <= two.killed) continue;
      two = {{{Form::vector, *first->second}, {Form::vector, *second->second}}, together};
    }
  }
  std::vector<Team> teams;
  if (one.killed > 0) teams.push_back(std::move(one));
  if (!teams.empty() && two.killed > teams[0].killed) teams.push_back(std::move(two));
  return teams;
}

KillMatrix SearchKills::matrix() const {
  KillMatrix matrix;
  matrix.defects = plan_.model_of(plan_.generators.front()).defects();
  for (std::size_t i = 0; i < plan_.generators.size(); ++i) {
    const GeneratorSpec& spec = plan_.generators[i];
    if (spec.defect == 0) {
      matrix.rows.push_back(
          {.behaviour = spec.family, .agents = plan_.model_of(spec).agents(), .cells = {}});
    }
    KillRow& row = matrix.rows.back();
    for (std::size_t repetition = 0; repetition < plan_.repetitions; ++repetition) {
      row.healthy_failures += counts_[i * plan_.repetitions + repetition].healthy_failures;
    }
    row.cells.push_back(cell_of(i));
  }
  return matrix;
}

}  // namespace jaywalk::search
