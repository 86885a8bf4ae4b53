#include "interpreter/coverage/lines.h"

#include <algorithm>

#include <fmt/format.h>

namespace jaywalk {
namespace {

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
