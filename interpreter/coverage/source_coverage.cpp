#include "interpreter/coverage/source_coverage.h"

#include <filesystem>
#include <set>
#include <string>

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

}  // namespace jaywalk
