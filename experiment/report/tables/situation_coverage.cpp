// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/report/stored_coverage.h"

namespace jaywalk {
namespace {

using nlohmann::ordered_json;

double percent(std::uint64_t covered, std::uint64_t bins) {
  return bins == 0 ? 0 : 100.0 * static_cast<double>(covered) / static_cast<double>(bins);
}

/// The number of its tests after which a row had covered this share of the bins that it covers in
/// the end.
std::uint64_t tests_until(const SituationCoverage& coverage, double share) {
  const double wanted = share * static_cast<double>(coverage.covered());
  for (const SituationCoverage::Growth& step : coverage.growth()) {
    if (static_cast<double>(step.covered) >= wanted) return step.tests;
  }
  return 0;
}

void add_rows(std::string& out, const std::vector<SituationRow>& rows) {
  std::size_t width = 9;
  for (const SituationRow& row : rows) width = std::max(width, row.behaviour.size());
  out += fmt::format("{:<{}} {:>6} {:>8} {:>13} {:>8} {:>10} {:>10}\n", "behaviour", width,
                     "agents", "tests", "bins covered", "", "half after", "90 % after");
  for (const SituationRow& row : rows) {
    const SituationCoverage& coverage = row.coverage;
    out += fmt::format("{:<{}} {:>6} {:>8} {:>6} of {:>3} {:>6.1f} % {:>10} {:>10}\n",
                       row.behaviour, width, row.agents, coverage.tests(), coverage.covered(),
                       row.bins(), percent(coverage.covered(), row.bins()),
                       tests_until(coverage, 0.5), tests_until(coverage, 0.9));
  }
}

/// Whether tests of any row can cover it.
bool can_cover(const std::vector<SituationRow>& rows, std::size_t item, std::size_t bin) {
  return rows.empty() || std::ranges::any_of(rows, [&](const SituationRow& row) {
           return row.reachable.empty() || row.reachable[item][bin];
         });
}

/// A note on bins that the file of reachable bins excludes although a test has covered them; empty
/// if there are none.
std::string contradiction(const std::vector<SituationRow>& rows) {
  std::uint64_t bins = 0;
  for (const SituationRow& row : rows) {
    for (std::size_t item = 0; item < row.reachable.size(); ++item) {
      for (std::size_t bin = 0; bin < row.reachable[item].size(); ++bin) {
        if (!row.reachable[item][bin] && row.coverage.counts()[item][bin] > 0) ++bins;
      }
    }
  }
  if (bins == 0) return {};
  return fmt::format(
      "\nexperiment.reachable is of another world: {} bins that it leaves out were covered; "
      "`jaywalk reach` writes it anew\n",
      bins);
}

void add_items(std::string& out, const std::vector<SituationRow>& rows) {
  const auto items = situation_items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::vector<std::uint64_t> times(items[i].bins.size());
    for (const SituationRow& row : rows) {
      for (std::size_t bin = 0; bin < times.size(); ++bin) {
        times[bin] += row.coverage.counts()[i][bin];
      }
    }
    const auto can_be = [&](std::size_t bin) { return times[bin] > 0 || can_cover(rows, i, bin); };
    std::uint64_t covered = 0;
    std::uint64_t coverable = 0;
    for (std::size_t bin = 0; bin < times.size(); ++bin) {
      if (times[bin] > 0) ++covered;
      if (can_be(bin)) ++coverable;
    }
    out +=
        fmt::format("\n{} ({}): {} of {}\n", items[i].name, items[i].summary, covered, coverable);
    for (std::size_t bin = 0; bin < times.size(); ++bin) {
      const std::string_view missing = can_be(bin) ? "hole" : "never";
      out += fmt::format("  {:<34} {:>10}\n", items[i].bins[bin],
                         times[bin] == 0 ? std::string(missing) : fmt::format("{}", times[bin]));
    }
  }
}

}  // namespace

ReachableBins reachable_with(const ReachableBins& reachable, std::uint32_t agents) {
  return agents == 1 ? reachable : ReachableBins();
}

std::string situation_text(const std::vector<SituationRow>& rows) {
  std::string out;
  add_rows(out, rows);
  add_items(out, rows);
  return out + contradiction(rows);
}

std::string situation_csv(const std::vector<SituationRow>& rows) {
  std::string out = "behaviour,agents,tests,item,bin,name,times\n";
  const auto items = situation_items();
  for (const SituationRow& row : rows) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t bin = 0; bin < items[i].bins.size(); ++bin) {
        out += fmt::format("{},{},{},{},{},\"{}\",{}\n", row.behaviour, row.agents,
                           row.coverage.tests(), items[i].name, bin + 1, items[i].bins[bin],
                           row.coverage.counts()[i][bin]);
      }
    }
  }
  return out;
}

std::string situation_json(const std::vector<SituationRow>& rows) {
  ordered_json items = ordered_json::array();
  for (const SituationItem& item : situation_items()) {
    items.push_back({{"name", item.name}, {"summary", item.summary}, {"bins", item.bins}});
  }
  ordered_json results = ordered_json::array();
  for (const SituationRow& row : rows) {
    ordered_json growth = ordered_json::array();
    for (const auto& step : row.coverage.growth()) growth.push_back({step.tests, step.covered});
    results.push_back({{"behaviour", row.behaviour},
                       {"agents", row.agents},
                       {"tests", row.coverage.tests()},
                       {"covered", row.coverage.covered()},
                       {"bins", row.bins()},
                       {"times", row.coverage.counts()},
                       {"growth", std::move(growth)}});
  }
  const ordered_json all{{"items", std::move(items)}, {"results", std::move(results)}};
  return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace jaywalk
