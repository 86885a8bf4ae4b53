#include "experiment/report/page.h"

#include <fmt/format.h>

#include "experiment/report/page.html.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

void put(std::string& page, std::string_view place, std::string_view content) {
  const auto at = page.find(place);
  page.replace(at, place.size(), content);
}

}  // namespace

std::string render_page(std::string_view kind, std::string_view title,
                        std::span<const PageSection> sections) {
  std::string contents;
  std::string body;
  for (const PageSection& section : sections) {
    if (section.html.empty()) continue;
    contents += fmt::format("<a href=\"#{}\">{}</a>\n", section.name, escaped(section.title));
    body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.name,
                        escaped(section.title), section.html);
  }
  std::string page(kPageHtml);
  put(page, "<!--TITLE-->", escaped(fmt::format("Jaywalk: {}", title)));
  put(page, "<!--BODY-->",
      fmt::format("<header><p class=\"kind\">{}</p><h1>{}</h1></header>\n<nav>{}</nav>\n"
                  "<main>\n{}</main>\n",
                  kind, escaped(title), contents, body));
  return page;
}

}  // namespace jaywalk::reporting
