// SPDX-License-Identifier: Apache-2.0
#include "interpreter/coverage/source_coverage.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include <fmt/format.h>

namespace jaywalk {
namespace {

// A key that does not depend on how a file's path was written.
std::string key_of(const Source& source) {
  return std::filesystem::path(source.name()).lexically_normal().string();
}

std::vector<CoveredCondition> conditions(const CoverageCounts& counts, const ProbeTexts& texts,
                                         std::size_t first, std::size_t count) {
  std::vector<CoveredCondition> result;
  for (std::size_t i = first; i < first + count; ++i) {
    const WrittenAs& written = texts.conditions[i];
    if (written.source != nullptr) {
      result.push_back({written.where, written.text, counts.conditions[i]});
    }
  }
  return result;
}

CoveredPlan covered_plan(const ProbedPlan& plan, std::size_t index, const CoverageCounts& counts,
                         const ProbeTexts& texts) {
  CoveredPlan made{.where = texts.plans[index].where,
                   .trigger = texts.plans[index].text,
                   .counts = counts.plans[index],
                   .conditions = conditions(counts, texts, plan.first_condition, plan.conditions)};
  for (std::size_t i = plan.first_formula; i < plan.first_formula + plan.formulas; ++i) {
    const WrittenAs& written = texts.formulas[i];
    if (written.source != nullptr) {
      made.formulas.push_back({written.where, written.text, counts.formulas[i]});
    }
  }
  return made;
}

void add_counts(std::vector<CoveredCondition>& sum, const std::vector<CoveredCondition>& more) {
  for (std::size_t i = 0; i < sum.size() && i < more.size(); ++i) {
    sum[i].counts.asked += more[i].counts.asked;
    sum[i].counts.held += more[i].counts.held;
  }
}

void add_counts(CoveredPlan& sum, const CoveredPlan& more) {
  sum.counts.relevant += more.counts.relevant;
  sum.counts.applicable += more.counts.applicable;
  sum.counts.chosen += more.counts.chosen;
  add_counts(sum.conditions, more.conditions);
  for (std::size_t i = 0; i < sum.formulas.size() && i < more.formulas.size(); ++i) {
    sum.formulas[i].counts.executed += more.formulas[i].counts.executed;
    sum.formulas[i].counts.failed += more.formulas[i].counts.failed;
  }
}

void count_outcomes(const std::vector<CoveredCondition>& conditions, Share& outcomes) {
  for (const CoveredCondition& condition : conditions) {
    // Each condition has two outcomes: that it holds, and that it does not.
    outcomes.of += 2;
    outcomes.covered += (condition.counts.held > 0 ? 1U : 0U) + (condition.failed() > 0 ? 1U : 0U);
  }
}

using Lines = std::map<std::uint32_t, CoveredLine>;

void add(Lines& lines, const CoveredPlace& where, std::uint64_t count, std::string gap) {
  CoveredLine& line = lines[where.line];
  line.count = std::max(line.count, count);
  if (!gap.empty()) line.gaps.push_back(std::move(gap));
}

std::string gap_of(const CoveredPlan& plan) {
  const PlanCounts& counts = plan.counts;
  if (counts.chosen > 0) return {};
  if (counts.relevant == 0) return "no such event: " + plan.trigger;
  if (counts.applicable == 0) {
    return fmt::format("never applicable, {} times relevant: {}", counts.relevant, plan.trigger);
  }
  return fmt::format("never chosen, {} times applicable: {}", counts.applicable, plan.trigger);
}

std::string gap_of(const CoveredCondition& condition) {
  if (condition.counts.asked == 0) return "never asked: " + condition.text;
  if (condition.counts.held == 0) return "never true: " + condition.text;
  if (condition.failed() == 0) return "never false: " + condition.text;
  return {};
}

std::string gap_of(const CoveredFormula& formula) {
  return formula.counts.executed == 0 ? "never executed: " + formula.text : std::string();
}

}  // namespace

CoverageTotals CoveredFile::totals() const {
  CoverageTotals totals;
  for (const auto& [place, plan] : plans) {
    totals.plans.add({plan.counts.chosen > 0 ? 1U : 0U, 1});
    count_outcomes(plan.conditions, totals.outcomes);
    for (const CoveredFormula& formula : plan.formulas) {
      totals.formulas.add({formula.counts.executed > 0 ? 1U : 0U, 1});
    }
  }
  for (const auto& [place, rule] : rules) count_outcomes(rule.conditions, totals.outcomes);
  return totals;
}

CoverageTotals SourceCoverage::totals() const {
  CoverageTotals totals;
  for (const auto& [name, file] : files) {
    const CoverageTotals of_file = file.totals();
    totals.plans.add(of_file.plans);
    totals.outcomes.add(of_file.outcomes);
    totals.formulas.add(of_file.formulas);
  }
  return totals;
}

void SourceCoverage::add(const SourceCoverage& other) {
  for (const auto& [name, file] : other.files) {
    CoveredFile& own = files[name];
    if (own.source == nullptr) own.source = file.source;
    for (const auto& [place, plan] : file.plans) {
      // By place: a file that several agents load, or that is included twice, is one file here.
      const auto [found, is_new] = own.plans.try_emplace(place, plan);
      if (!is_new) add_counts(found->second, plan);
    }
    for (const auto& [place, rule] : file.rules) {
      const auto [found, is_new] = own.rules.try_emplace(place, rule);
      if (!is_new) add_counts(found->second.conditions, rule.conditions);
    }
  }
}

SourceCoverage locate(const Probes& probes, const CoverageCounts& counts, const ProbeTexts& texts) {
  SourceCoverage coverage;
  const auto file_of = [](SourceCoverage& one, const SourcePtr& source) -> CoveredFile& {
    CoveredFile& file = one.files[key_of(*source)];
    file.source = source;
    return file;
  };
  for (std::size_t i = 0; i < probes.plans().size(); ++i) {
    if (texts.plans[i].source == nullptr) continue;
    SourceCoverage one;
    file_of(one, texts.plans[i].source)
        .plans.emplace(texts.plans[i].where, covered_plan(probes.plans()[i], i, counts, texts));
    coverage.add(one);
  }
  for (std::size_t i = 0; i < probes.rules().size(); ++i) {
    const WrittenAs& written = texts.rules[i];
    if (written.source == nullptr) continue;
    const ProbedRule& rule = probes.rules()[i];
    SourceCoverage one;
    file_of(one, written.source)
        .rules.emplace(written.where, CoveredRule{written.where, written.text,
                                                  conditions(counts, texts, rule.first_condition,
                                                             rule.conditions)});
    coverage.add(one);
  }
  return coverage;
}

SourceCoverage locate_in_files(const Probes& probes, const CoverageCounts& counts,
                               const SourceFiles& files) {
  // Only their names are kept in programs; the texts are read again to find what stands where.
  std::set<std::string> names;
  for (const ProbedPlan& plan : probes.plans()) names.insert(plan.plan->file);
  for (const ProbedRule& rule : probes.rules()) {
    if (rule.where.source != nullptr) names.insert(rule.where.source->name());
  }
  std::vector<SourcePtr> sources;
  for (const std::string& name : names) {
    auto source = files.read(name);
    if (source.ok()) sources.push_back(std::move(source).value());
  }
  return locate(probes, counts, find_texts(probes, sources));
}

Lines covered_lines(const CoveredFile& file) {
  Lines lines;
  const auto add_conditions = [&](const std::vector<CoveredCondition>& conditions) {
    for (const CoveredCondition& each : conditions) {
      add(lines, each.where, each.counts.asked, gap_of(each));
    }
  };
  for (const auto& [place, plan] : file.plans) {
    add(lines, place, plan.counts.chosen, gap_of(plan));
    // The conditions of a plan that was not relevant need no marks.
    add_conditions(plan.counts.relevant > 0 ? plan.conditions : std::vector<CoveredCondition>{});
    for (const CoveredFormula& formula : plan.formulas) {
      add(lines, formula.where, formula.counts.executed,
          plan.counts.chosen > 0 ? gap_of(formula) : std::string());
    }
  }
  for (const auto& [place, rule] : file.rules) {
    if (rule.conditions.empty()) continue;
    add(lines, place, rule.conditions.front().counts.asked, {});
    add_conditions(rule.conditions);
  }
  return lines;
}

std::string percent(const Share& share) {
  if (share.of == 0) return "-";
  return fmt::format("{:.1f} %",
                     100.0 * static_cast<double>(share.covered) / static_cast<double>(share.of));
}

}  // namespace jaywalk
