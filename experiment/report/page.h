#pragma once

// A self-contained page: the looks that all reports share, light, dark, narrow and on
// paper (page.html).

#include <span>
#include <string>
#include <string_view>

namespace jaywalk::reporting {

struct PageSection {
  /// The name of the section's anchor.
  std::string_view name;
  std::string_view title;
  /// Sections without are left out.
  std::string html;
};

/// `kind`: the kind of the page, shown above the title.
[[nodiscard]] std::string render_page(std::string_view kind, std::string_view title,
                                      std::span<const PageSection> sections);

}  // namespace jaywalk::reporting
