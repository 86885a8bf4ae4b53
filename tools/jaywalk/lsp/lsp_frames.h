#pragma once

// The outermost layer of the language server protocol: texts behind a header with their length.

#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace jaywalk::lsp {

/// Longer messages are refused.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20U;

struct Frame {
  std::string content;
  /// The header was none, or the length too great; there is no content.
  bool is_broken = false;
};

/// The next message; nothing at the end. After a broken one the next header is looked for.
[[nodiscard]] std::optional<Frame> read_frame(std::istream& in);
void write_frame(std::ostream& out, std::string_view content);

}  // namespace jaywalk::lsp
