#include "experiment/report/report.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiment/report/html.h"
#include "experiment/report/page.html.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

constexpr std::array kSections = {
#define JAYWALK_SECTION(name, title) Section{#name, title, section::name},
#include "experiment/report/sections.def"
#undef JAYWALK_SECTION
};

void put(std::string& page, std::string_view place, std::string_view content) {
  const auto at = page.find(place);
  page.replace(at, place.size(), content);
}

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
  numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
  return numbers;
}

const Summary* find_summary(const Comparison& comparison, std::string_view behaviour,
                            std::uint32_t agents) {
  const auto found = std::ranges::find_if(comparison.summaries, [&](const Summary& summary) {
    return summary.behaviour == behaviour && summary.agents == agents;
  });
  return found == comparison.summaries.end() ? nullptr : &*found;
}

std::string render_page(std::string_view title, const std::string& body) {
  std::string page(kPageHtml);
  put(page, "<!--TITLE-->", escaped(title));
  put(page, "<!--BODY-->", body);
  return page;
}

std::string render_report(const ReportData& data) {
  std::string contents;
  std::string body;
  for (const Section& section : sections()) {
    const std::string content = section.render(data);
    if (content.empty()) continue;
    contents += fmt::format("<a href=\"#{}\">{}</a>\n", section.name, escaped(section.title));
    body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.name,
                        escaped(section.title), content);
  }
  const std::string_view name = file_name(data.comparison.scenario);
  return render_page(
      fmt::format("Jaywalk: {}", name),
      fmt::format("<header><p class=\"kind\">Jaywalk test "
                  "report</p><h1>{}</h1></header>\n<nav>{}</nav>\n<main>\n{}</main>\n",
                  escaped(name), contents, body));
}

}  // namespace jaywalk::reporting
