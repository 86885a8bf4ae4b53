#include "interpreter/syntax/format/formatter_columns.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "interpreter/support/text.h"

namespace jaywalk::format {
namespace {

class Columns {
 public:
  Columns(std::string_view text, std::vector<ColumnMark> marks, std::size_t width)
      : marks_(std::move(marks)), width_(width) {
    for (const std::string_view line : lines_of(text)) lines_.emplace_back(line);
  }

  std::string run() {
    // From left to right, since each pass moves what stands behind.
    align({TokenKind::colon, TokenKind::colon});
    align({TokenKind::arrow, TokenKind::rule});
    align({TokenKind::end_of_text, TokenKind::end_of_text});
    std::string text;
    for (const std::string& line : lines_) text += line + '\n';
    return text;
  }

 private:
  void align(std::array<TokenKind, 2> kinds) {
    std::vector<ColumnMark*> run;
    for (ColumnMark& mark : marks_) {
      if (std::ranges::find(kinds, mark.kind) == kinds.end()) continue;
      const bool goes_on = !run.empty() && mark.line == run.back()->line + 1 &&
                           mark.former_column == run.back()->former_column;
      if (!goes_on) {
        pad(run);
        run.clear();
      }
      run.push_back(&mark);
    }
    pad(run);
  }

  [[nodiscard]] std::size_t column_of(const ColumnMark& mark) const {
    return character_count(std::string_view(lines_[mark.line]).substr(0, mark.offset));
  }

  void pad(std::span<ColumnMark* const> run) {
    std::size_t widest = 0;
    for (const ColumnMark* mark : run) widest = std::max(widest, column_of(*mark));
    const bool fits = std::ranges::all_of(run, [&](const ColumnMark* mark) {
      return character_count(lines_[mark->line]) + widest - column_of(*mark) <= width_;
    });
    if (!fits) return;
    for (const ColumnMark* mark : run) {
      const std::size_t blanks = widest - column_of(*mark);
      const auto [kind, line, offset, former] = *mark;
      lines_[line].insert(offset, blanks, ' ');
      auto other = std::ranges::lower_bound(marks_, line, {}, &ColumnMark::line);
      for (; other != marks_.end() && other->line == line; ++other) {
        if (other->offset >= offset) other->offset += blanks;
      }
    }
  }

  std::vector<std::string> lines_;
  std::vector<ColumnMark> marks_;
  std::size_t width_;
};

}  // namespace

std::string with_columns(std::string text, std::vector<ColumnMark> marks, std::size_t width) {
  return Columns(text, std::move(marks), width).run();
}

}  // namespace jaywalk::format
