#include "experiment/feedback.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace jaywalk {
namespace {

template <class Number>
bool read_number(std::string_view& text, Number& value) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

}  // namespace

std::string feedback_text(const std::vector<CoveredBin>& feedback) {
  std::string text;
  for (const CoveredBin& each : feedback) {
    text += fmt::format("{}{} {} {}", text.empty() ? "" : "; ", each.item, each.bin, each.times);
  }
  return text;
}

std::optional<std::vector<CoveredBin>> parse_feedback(std::string_view text) {
  std::vector<CoveredBin> feedback;
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    if (blank == 0 || blank == std::string_view::npos) return std::nullopt;
    CoveredBin bin{.item = std::string(text.substr(0, blank))};
    text.remove_prefix(blank);
    if (!read_number(text, bin.bin) || !read_number(text, bin.times)) return std::nullopt;
    feedback.push_back(std::move(bin));
    if (text.empty()) break;
    if (!text.starts_with("; ")) return std::nullopt;
    text.remove_prefix(2);
  }
  return feedback;
}

std::vector<CoveredBin> told(const SituationCoverage& coverage) {
  std::vector<CoveredBin> feedback;
  const auto items = situation_items();
  for (std::size_t item = 0; item < items.size(); ++item) {
    const std::vector<std::uint64_t>& times = coverage.counts()[item];
    for (std::uint32_t bin = 0; bin < times.size(); ++bin) {
      if (times[bin] > 0) feedback.push_back({std::string(items[item].name), bin + 1, times[bin]});
    }
  }
  return feedback;
}

CoverageFeedback::CoverageFeedback(const ExperimentPlan& plan, std::uint64_t generation,
                                   const SituationTable& table)
    : plan_(plan), generation_(generation), table_(table) {
  const std::uint64_t generations = (plan.tests + generation - 1) / generation;
  cells_.resize(plan.behaviours.size() * plan.agents.size());
  for (Cell& cell : cells_) {
    cell.missing.assign(generations, generation);
    cell.missing.back() = plan.tests - (generations - 1) * generation;
    cell.told.emplace_back();
  }
}

CoverageFeedback::Cell& CoverageFeedback::cell_of(const TestCase& test) {
  const auto place = std::ranges::find(plan_.agents, test.agents) - plan_.agents.begin();
  return cells_[test.behaviour * plan_.agents.size() + static_cast<std::size_t>(place)];
}

std::optional<std::vector<CoveredBin>> CoverageFeedback::wait_for(const TestCase& test) {
  const std::uint64_t generation = test.number / generation_;
  std::unique_lock lock(mutex_);
  Cell& cell = cell_of(test);
  changed_.wait(lock, [&] { return given_up_ || cell.complete >= generation; });
  if (given_up_) return std::nullopt;
  return cell.told[generation];
}

void CoverageFeedback::finished(const TestCase& test) {
  const std::lock_guard lock(mutex_);
  Cell& cell = cell_of(test);
  --cell.missing[test.number / generation_];
  while (cell.complete < cell.missing.size() && cell.missing[cell.complete] == 0) {
    const std::uint64_t first = cell.complete * generation_;
    table_.add_to(cell.coverage, test.behaviour, test.agents, first,
                  std::min(first + generation_, plan_.tests));
    cell.told.push_back(told(cell.coverage));
    ++cell.complete;
  }
  changed_.notify_all();
}

void CoverageFeedback::give_up() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  changed_.notify_all();
}

}  // namespace jaywalk
