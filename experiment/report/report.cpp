#include "experiment/report/report.h"

#include <algorithm>
#include <array>

#include "experiment/report/html.h"

namespace jaywalk::reporting {
namespace {

constexpr std::array kSections = {
#define JAYWALK_SECTION(name, title) Section{#name, title, section::name},
#include "experiment/report/sections.def"
#undef JAYWALK_SECTION
};

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

std::span<const Section> sections() { return kSections; }

std::vector<std::string> behaviours_of(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const Summary& summary : comparison.summaries) {
    if (std::ranges::find(names, summary.behaviour) == names.end()) {
      names.push_back(summary.behaviour);
    }
  }
  return names;
}

std::vector<std::uint32_t> agents_of(const Comparison& comparison) {
  std::vector<std::uint32_t> numbers;
  for (const Summary& summary : comparison.summaries) numbers.push_back(summary.agents);
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

const Summary* find_summary(const Comparison& comparison, std::string_view behaviour,
                            std::uint32_t agents) {
  const auto found = std::ranges::find_if(comparison.summaries, [&](const Summary& summary) {
    return summary.behaviour == behaviour && summary.agents == agents;
  });
  return found == comparison.summaries.end() ? nullptr : &*found;
}

const ReplayLink* find_replay(const ReportData& data, const TestKey& test) {
  const auto found = std::ranges::find_if(data.replays, [&](const ReplayLink& link) {
    return link.test.behaviour == test.behaviour && link.test.agents == test.agents &&
           link.test.number == test.number;
  });
  return found == data.replays.end() ? nullptr : &*found;
}

std::string render_report(const ReportData& data) {
  std::vector<PageSection> written;
  for (const Section& section : sections()) {
    written.push_back({section.name, section.title, section.render(data)});
  }
  return render_page("Jaywalk test report", file_name(data.comparison.scenario), written);
}

}  // namespace jaywalk::reporting
