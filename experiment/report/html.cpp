// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/html.h"

#include <cmath>

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

std::string decimal(std::optional<double> value, int decimals) {
  if (!value || std::isnan(*value)) return "–";
  if (std::isinf(*value)) return *value > 0 ? "∞" : "−∞";
  return fmt::format("{:.{}f}", *value, decimals);
}

std::string compact(double value) {
  const double size = std::fabs(value);
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (size >= 1e6 || (size > 0 && size < 1e-4)) return fmt::format("{:.3g}", value);
  // Values that four digits would round to 10,000 are written like 10,000.
  if (size >= 9999.5)
    return grouped(static_cast<std::uint64_t>(std::llround(size))).insert(0, value < 0 ? "−" : "");
  return fmt::format("{:.4g}", value);
}

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (std::size_t at = text.size(); at > 3;) {
    at -= 3;
    text.insert(at, ",");
  }
  return text;
}

std::string p_value(double p) { return p < 0.001 ? "&lt; 0.001" : fmt::format("{:.3f}", p); }

std::string plural(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(count), noun, count == 1 ? "" : "s");
}

std::string series_attributes(std::size_t series) {
  return fmt::format("class=\"c{}\" data-series=\"{}\"", series % kColours, series);
}

std::string marker(std::size_t series, double x, double y) {
  constexpr std::size_t kMarkers = 7;
  switch (series % kMarkers) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"currentColor\"/>", x,
                         y);
    case 1:
      return fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"5.4\" height=\"5.4\" fill=\"currentColor\"/>",
          x - 2.7, y - 2.7);
    case 2:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l3.6 6.2h-7.2z\" fill=\"currentColor\"/>", x,
                         y - 3.8);
    case 3:
      return fmt::format(
          "<path d=\"M{:.1f} {:.1f}l3.8 3.8l-3.8 3.8l-3.8 -3.8z\" "
          "fill=\"currentColor\"/>",
          x, y - 3.8);
    case 4:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l6 6m0 -6l-6 6\" stroke-width=\"2\"/>", x - 3,
                         y - 3);
    case 5:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" class=\"hollow\"/>", x, y);
    default:
      return fmt::format("<path d=\"M{:.1f} {:.1f}h7m-3.5 -3.5v7\" stroke-width=\"2\"/>", x - 3.5,
                         y);
  }
}

void Table::column(std::string_view title, Align align) {
  columns_.push_back({std::string(title), align});
}

void Table::row(std::vector<std::string> cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool left = i < columns_.size() && columns_[i].align == Align::left;
    rows_ += fmt::format("<td{}>{}</td>", left ? " class=\"l\"" : "", cells[i]);
  }
  rows_ += "</tr>\n";
}

void Table::heading(std::string_view text) {
  rows_ += fmt::format("<tr><th colspan=\"{}\" class=\"l group\" scope=\"rowgroup\">{}</th></tr>\n",
                       columns_.size(), escaped(text));
}

std::string Table::html() const {
  std::string head;
  for (const Column& column : columns_) {
    head += fmt::format("<th{} scope=\"col\">{}</th>",
                        column.align == Align::left ? " class=\"l\"" : "", column.title);
  }
  return fmt::format(
      "<div class=\"scroll\" "
      "tabindex=\"0\"><table><thead><tr>{}</tr></thead>\n<tbody>{}</tbody></table></div>\n",
      head, rows_);
}

std::string details(std::string_view summary, const std::string& content) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", escaped(summary), content);
}

std::string paragraph(std::string_view text) { return fmt::format("<p>{}</p>\n", text); }

std::string figure(std::string_view caption, const std::string& picture) {
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption, picture);
}

std::string gallery(const std::string& figures, PictureSize size) {
  const std::string_view classes = size == PictureSize::small  ? "gallery small"
                                   : size == PictureSize::wide ? "gallery wide"
                                                               : "gallery";
  return fmt::format("<div class=\"{}\">\n{}</div>\n", classes, figures);
}

std::string term(std::string_view name, std::string_view html) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html);
}

std::string terms(std::string_view entries) { return fmt::format("<dl>\n{}</dl>\n", entries); }

std::string legend(const std::vector<std::string>& names) {
  std::string items;
  for (std::size_t i = 0; i < names.size(); ++i) {
    items += fmt::format(
        "<li><label><input type=\"checkbox\" checked data-switch=\"{}\"><svg class=\"mark c{}\" "
        "viewBox=\"0 0 24 12\" width=\"24\" height=\"12\" aria-hidden=\"true\"><path d=\"M1 6h22\" "
        "stroke-width=\"2\"/>{}</svg>{}</label></li>\n",
        i, i % kColours, marker(i, 12, 6), escaped(names[i]));
  }
  return fmt::format("<ul class=\"legend\">\n{}</ul>\n", items);
}

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
