// SPDX-License-Identifier: Apache-2.0
#pragma once

// Self-contained pages, and their building blocks: numbers, tables, the styles of series.

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk::reporting {

/// The value with `decimals` digits after the point, `–` if there is none, `∞` if it is infinite.
[[nodiscard]] std::string decimal(std::optional<double> value, int decimals);
/// The value with about four digits, for axes and lists: `0.25`, `12.5`, `1,200`, `2.5e6`.
[[nodiscard]] std::string compact(double value);
/// `12,345`.
[[nodiscard]] std::string grouped(std::uint64_t value);
/// `0.032`, `< 0.001`.
[[nodiscard]] std::string p_value(double p);
[[nodiscard]] std::string plural(std::uint64_t count, std::string_view noun);

/// Colours repeat after as many; markers too, but out of step with them.
inline constexpr std::size_t kColours = 8;

/// The attributes of a group that belongs to a series: its colour, and the key for the page's
/// switches.
[[nodiscard]] std::string series_attributes(std::size_t series);
/// The mark of a series around that point, as SVG.
[[nodiscard]] std::string marker(std::size_t series, double x, double y);

enum class Align { left, right };

/// A table that scrolls by itself where the page is narrow. Cells are HTML.
class Table {
 public:
  void column(std::string_view title, Align align = Align::right);
  void columns(std::initializer_list<std::string_view> titles, Align align = Align::right) {
    for (const std::string_view title : titles) column(title, align);
  }
  void row(std::vector<std::string> cells);
  /// A row over the whole width.
  void heading(std::string_view text);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string html() const;

 private:
  struct Column {
    std::string title;
    Align align;
  };
  std::vector<Column> columns_;
  std::string rows_;
};

/// Shown, and printed, when the reader has unfolded it.
[[nodiscard]] std::string details(std::string_view summary, const std::string& content);
[[nodiscard]] std::string paragraph(std::string_view text);
/// A picture with its caption.
[[nodiscard]] std::string figure(std::string_view caption, const std::string& picture);
enum class PictureSize { small, normal, wide };
/// Pictures side by side, as many as there is room for.
[[nodiscard]] std::string gallery(const std::string& figures,
                                  PictureSize size = PictureSize::normal);
/// An entry of a list of terms with descriptions, and the list; both are HTML.
[[nodiscard]] std::string term(std::string_view name, std::string_view html);
[[nodiscard]] std::string terms(std::string_view entries);
/// The names of series with their marks; switches them on and off.
[[nodiscard]] std::string legend(const std::vector<std::string>& names);

struct PageSection {
  /// The name of the section's anchor.
  std::string_view name;
  std::string_view title;
  /// Sections without are left out.
  std::string html;
};

/// A page with the looks that all reports share, light, dark, narrow and on paper (page.html).
/// `kind`: the kind of the page, shown above the title.
[[nodiscard]] std::string render_page(std::string_view kind, std::string_view title,
                                      std::span<const PageSection> sections);

}  // namespace jaywalk::reporting
