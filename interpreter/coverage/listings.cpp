// SPDX-License-Identifier: Apache-2.0
// Coverage as a listing, and as a tracefile of LCOV, which tools for continuous integration read.
// The format is that of geninfo(1): for each file its functions (plans), branches (outcomes of
// conditions) and lines.

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {
namespace {

/// Two plans may have the same trigger, but names must differ; commas separate fields.
std::string name_of(const CoveredPlan& plan) {
  std::string name = fmt::format("{}:{}:{}", plan.trigger, plan.where.line, plan.where.column);
  std::replace(name.begin(), name.end(), ',', ';');
  return name;
}

void add_functions(std::string& out, const CoveredFile& file) {
  std::size_t hit = 0;
  for (const auto& [place, plan] : file.plans) {
    out += fmt::format("FN:{},{}\n", place.line, name_of(plan));
  }
  for (const auto& [place, plan] : file.plans) {
    out += fmt::format("FNDA:{},{}\n", plan.counts.chosen, name_of(plan));
    hit += plan.counts.chosen > 0 ? 1U : 0U;
  }
  out += fmt::format("FNF:{}\nFNH:{}\n", file.plans.size(), hit);
}

/// Numbers each condition's branches: 0 if it held, 1 if it did not.
class Branches {
 public:
  explicit Branches(std::string& out) : out_(out) {}

  void add(const std::vector<CoveredCondition>& conditions) {
    for (const CoveredCondition& condition : conditions) {
      const std::size_t block = blocks_[condition.where.line]++;
      add(condition, block, 0, condition.counts.held);
      add(condition, block, 1, condition.failed());
    }
  }
  void finish() { out_ += fmt::format("BRF:{}\nBRH:{}\n", found_, hit_); }

 private:
  void add(const CoveredCondition& condition, std::size_t block, int branch, std::uint64_t times) {
    const std::string taken = condition.counts.asked == 0 ? "-" : fmt::format("{}", times);
    out_ += fmt::format("BRDA:{},{},{},{}\n", condition.where.line, block, branch, taken);
    ++found_;
    hit_ += times > 0 ? 1U : 0U;
  }

  std::string& out_;
  std::map<std::uint32_t, std::size_t> blocks_;  // of a line
  std::size_t found_ = 0;
  std::size_t hit_ = 0;
};

std::string text_cell(const Share& share) {
  return fmt::format("{:>5}/{:<5}{:>8}", share.covered, share.of, percent(share));
}

std::string row(std::string_view name, const CoverageTotals& totals, std::size_t width) {
  return fmt::format("{:<{}} {} {} {}\n", name, width, text_cell(totals.plans),
                     text_cell(totals.outcomes), text_cell(totals.formulas));
}

void list(std::string& out, const CoveredFile& file) {
  const auto lines = covered_lines(file);
  const std::string_view text = file.source->text();
  const auto count = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) +
                     (text.empty() || text.ends_with('\n') ? 0U : 1U);
  for (std::uint32_t number = 1; number <= count; ++number) {
    const auto line = lines.find(number);
    std::string times = "-";
    if (line != lines.end()) {
      times = line->second.count == 0 ? "#####" : fmt::format("{}", line->second.count);
    }
    out += fmt::format("{:>11}:{:>5}:{}\n", times, number, file.source->line(number));
    if (line == lines.end()) continue;
    for (const std::string& gap : line->second.gaps) out += fmt::format("{:>17}^ {}\n", "", gap);
  }
}

}  // namespace

std::string coverage_lcov(const SourceCoverage& coverage) {
  std::string out;
  for (const auto& [name, file] : coverage.files) {
    out += fmt::format("TN:\nSF:{}\n", name);
    add_functions(out, file);
    Branches branches(out);
    for (const auto& [place, plan] : file.plans) branches.add(plan.conditions);
    for (const auto& [place, rule] : file.rules) branches.add(rule.conditions);
    branches.finish();
    std::size_t hit = 0;
    const auto lines = covered_lines(file);
    for (const auto& [number, line] : lines) {
      out += fmt::format("DA:{},{}\n", number, line.count);
      hit += line.count > 0 ? 1U : 0U;
    }
    out += fmt::format("LF:{}\nLH:{}\nend_of_record\n", lines.size(), hit);
  }
  return out;
}

std::string coverage_text(const SourceCoverage& coverage) {
  std::size_t width = 5;
  for (const auto& [name, file] : coverage.files) width = std::max(width, name.size());
  std::string out = fmt::format("{:<{}} {:<19} {:<19} {}\n", "file", width, "plans chosen",
                                "outcomes seen", "formulas executed");
  for (const auto& [name, file] : coverage.files) out += row(name, file.totals(), width);
  out += row("total", coverage.totals(), width);
  for (const auto& [name, file] : coverage.files) {
    out += fmt::format("\n{}\n", name);
    list(out, file);
  }
  return out;
}

}  // namespace jaywalk
