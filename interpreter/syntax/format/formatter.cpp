// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/format/formatter.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "interpreter/support/text.h"
#include "interpreter/syntax/format/formatter_items.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/printer.h"

namespace jaywalk {
namespace {

using enum TokenKind;
using format::Item;

constexpr std::size_t kIndent = 2;
/// Formulas stand below the first one, behind `<- `.
constexpr std::size_t kBodyIndent = 5;

class Formatter {
 public:
  explicit Formatter(std::vector<Item> items) : items_(std::move(items)) {}

  std::string run() {
    components(0, items_.size(), 0, 0);
    if (!out_.empty()) out_ += '\n';
    return format::with_columns(std::move(out_), std::move(marks_), kLineWidth);
  }

 private:
  [[nodiscard]] TokenKind kind(std::size_t i) const {
    return i < items_.size() ? items_[i].kind : end_of_text;
  }
  /// The first token from `i` on.
  [[nodiscard]] std::size_t token_from(std::size_t i) const {
    while (i < items_.size() && items_[i].is_comment) ++i;
    return i;
  }
  [[nodiscard]] static bool opens(TokenKind kind) {
    return kind == open || kind == body_open || kind == open_list || kind == open_brace;
  }
  /// The first token of a kind outside of brackets, or `end`.
  [[nodiscard]] std::size_t find(TokenKind wanted, std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (items_[i].kind == wanted && !items_[i].is_comment) return i;
      if (opens(items_[i].kind)) i = items_[i].partner;
    }
    return end;
  }

  // Writing.

  void new_line(std::size_t indent, bool empty_line = false) {
    if (out_.empty()) return;
    out_ += empty_line ? "\n\n" : "\n";
    line_ += empty_line ? 2 : 1;
    line_begin_ = out_.size();
    out_.append(indent, ' ');
    column_ = indent;
  }
  void write(std::string_view text) {
    out_ += text;
    const std::size_t last_break = text.rfind('\n');
    if (last_break == std::string_view::npos) {
      column_ += character_count(text);
    } else {
      column_ = character_count(text.substr(last_break + 1));
      line_ += static_cast<std::size_t>(std::ranges::count(text, '\n'));
      line_begin_ = out_.size() - (text.size() - last_break - 1);
    }
  }
  void write_item(std::size_t i) {
    const bool ends_line = items_[i].is_line_comment && items_[i].breaks_before == 0;
    if (ends_line) mark(i);
    write(items_[i].text);
  }
  /// The next text may be aligned with texts of its kind in the lines around.
  void mark(std::size_t i) {
    marks_.push_back({.kind = items_[i].kind,
                      .line = line_,
                      .offset = out_.size() - line_begin_,
                      .former_column = items_[i].column});
  }

  // Next to a comment, line breaks stay as they are.
  [[nodiscard]] bool is_beside_comment(std::size_t i) const {
    return items_[i].is_comment || (i > 0 && items_[i - 1].is_comment);
  }
  [[nodiscard]] bool must_break(std::size_t i) const {
    return items_[i].begins_formula || (is_beside_comment(i) && items_[i].breaks_before > 0);
  }
  void blank(std::size_t i) {
    const bool ends_line =
        items_[i].is_comment && (i + 1 == items_.size() || items_[i + 1].breaks_before > 0);
    if (ends_line) {
      write("  ");
    } else if (is_beside_comment(i) || items_[i].blank_before) {
      write(" ");
    }
  }

  // Whether the items fit on the rest of the line, as one line.
  [[nodiscard]] bool fits(std::size_t begin, std::size_t end, std::size_t used) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (items_[i].is_comment) return false;
      used += character_count(items_[i].text) + (i > begin && items_[i].blank_before ? 1 : 0);
      if (used > kLineWidth) return false;
    }
    return true;
  }
  // How many columns the items take until a line may be broken or a comment comes.
  [[nodiscard]] std::size_t unit_width(std::size_t begin, std::size_t end) const {
    std::size_t width = 0;
    for (std::size_t i = begin; i < end && width <= kLineWidth; ++i) {
      if (i > begin && (items_[i].may_break || items_[i].is_comment)) break;
      width += character_count(items_[i].text) + (items_[i].blank_before ? 1 : 0);
    }
    return width;
  }
  // The content of brackets is broken only if it does not fit into a whole line.
  [[nodiscard]] bool is_call_too_wide(std::size_t begin, std::size_t end,
                                      std::size_t indent) const {
    std::size_t width = 0;
    for (std::size_t i = begin; i < end && width <= kLineWidth; ++i) {
      if (i > begin && (items_[i].may_break || items_[i].is_comment)) break;
      const std::size_t last = opens(items_[i].kind) ? std::min(items_[i].partner, end - 1) : i;
      for (; i <= last && width <= kLineWidth; ++i) {
        width += character_count(items_[i].text) + (items_[i].blank_before ? 1 : 0);
      }
      --i;
    }
    return column_ + width > kLineWidth && indent + width <= kLineWidth;
  }
  [[nodiscard]] bool is_on_one_line(std::size_t begin, std::size_t end) const {
    return std::all_of(items_.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
                       items_.begin() + static_cast<std::ptrdiff_t>(end), [](const Item& item) {
                         return item.breaks_before == 0 && !item.is_comment;
                       });
  }

  // Items one after another, wrapped where they do not fit; the first is written where we are.
  void flow(std::size_t begin, std::size_t end, std::size_t indent) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) gap(i, end, indent);
      write_item(i);
    }
  }
  /// Writes a component on one line, with marks on its colon and arrow.
  void one_line(std::size_t begin, std::size_t end) {
    const std::size_t arrow_at = std::min(find(arrow, begin, end), find(rule, begin, end));
    const std::size_t colon_at = find(colon, begin, arrow_at);
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) blank(i);
      if (i == colon_at || i == arrow_at) mark(i);
      write_item(i);
    }
  }
  void gap(std::size_t i, std::size_t end, std::size_t indent) {
    const bool is_too_wide =
        items_[i].may_break && !is_beside_comment(i) && column_ > indent &&
        (column_ + unit_width(i, end) > kLineWidth || is_call_too_wide(i, end, indent));
    if (must_break(i) || is_too_wide) {
      new_line(indent);
    } else {
      blank(i);
    }
  }

  // Between items that stand on lines of their own. Writes the comments from `begin` on and the
  // line break before the token behind them, which it returns.
  enum class EmptyLines { drop, keep };
  std::size_t next_line(std::size_t begin, std::size_t comment_indent, std::size_t indent,
                        EmptyLines empty_lines) {
    const std::size_t token = token_from(begin);
    bool breaks = token == items_.size();
    for (std::size_t i = begin; i <= token && i < items_.size(); ++i) {
      breaks = breaks || items_[i].breaks_before > 0;
    }
    for (std::size_t i = begin; i <= token && i < items_.size(); ++i) {
      if (items_[i].breaks_before > 0 || !breaks) {
        const bool keeps = empty_lines == EmptyLines::keep && items_[i].breaks_before > 1;
        new_line(i == token ? indent : comment_indent, keeps);
        breaks = true;
      } else if (!out_.empty()) {
        blank(i);
      }
      if (i < token) write_item(i);
    }
    return token;
  }

  // Components.

  /// Those between two items, and the line break before what follows them.
  void components(std::size_t begin, std::size_t end, std::size_t outer_indent,
                  std::size_t end_indent) {
    std::size_t indent = outer_indent;
    while (true) {
      const std::size_t first = token_from(begin);
      const TokenKind word = kind(first) == open_brace ? kind(token_from(first + 1)) : end_of_text;
      const std::size_t own_indent = first >= end                                ? end_indent
                                     : word == end_word && indent > outer_indent ? indent - kIndent
                                                                                 : indent;
      (void)next_line(begin, indent, own_indent, EmptyLines::keep);
      if (first >= end) return;
      indent = own_indent;
      if (kind(first) == open_brace) {
        begin = brace(first, indent);
        if (word == begin_word) indent += kIndent;
      } else {
        begin = std::min(find(stop, first, end) + 1, end);
        component(first, begin, indent);
      }
    }
  }

  // A directive, or the sub-plans of the plan before. Returns what follows it.
  std::size_t brace(std::size_t i, std::size_t indent) {
    const std::size_t last = items_[i].partner;
    if (begins_plan(kind(token_from(i + 1)))) {
      write_item(i);
      components(i + 1, last, indent + kIndent, indent);
      write_item(last);
    } else {
      flow(i, last + 1, indent + kIndent);
    }
    return last + 1;
  }

  [[nodiscard]] static bool begins_plan(TokenKind kind) {
    return kind == at || kind == plus || kind == minus || kind == caret;
  }

  void component(std::size_t begin, std::size_t end, std::size_t indent) {
    const std::size_t inner = indent + kIndent;
    const std::size_t neck = find(rule, begin, end);
    if (is_on_one_line(begin, end) && fits(begin, end, column_)) {
      one_line(begin, end);
    } else if (begins_plan(kind(begin))) {
      plan(begin, end, indent);
    } else if (neck < end) {
      flow(begin, neck + 1, inner);
      flow(next_line(neck + 1, inner, inner, EmptyLines::drop), end, inner);
    } else {
      flow(begin, end, inner);
    }
  }

  void plan(std::size_t begin, std::size_t end, std::size_t indent) {
    const std::size_t inner = indent + kIndent;
    if (kind(begin) == at) {
      const std::size_t label_end = part(begin, trigger_from(begin, end), inner);
      begin = next_line(label_end, indent, indent, EmptyLines::drop);
    }
    const std::size_t arrow_at = find(arrow, begin, end);
    const std::size_t condition = std::min(find(goal_condition, begin, end), arrow_at);
    const std::size_t context = std::min(find(colon, begin, end), condition);
    std::size_t at_item = part(begin, context, inner);
    if (context < condition) {
      if (at_item == context && fits(context, condition, column_ + 1)) {
        write(" ");
      } else {
        (void)next_line(at_item, inner, inner, EmptyLines::drop);
      }
      at_item = part(context, condition, inner + kIndent);
    }
    if (condition < arrow_at) {
      (void)next_line(at_item, inner, inner, EmptyLines::drop);
      at_item = part(condition, arrow_at, inner + kIndent);
    }
    if (arrow_at == end) return;
    (void)next_line(at_item, inner, inner, EmptyLines::drop);
    write_item(arrow_at);
    const std::size_t first = same_line(arrow_at + 1, indent + kBodyIndent);
    formulas(first, end, indent + kBodyIndent);
  }

  /// The first token of the trigger of a plan with a label.
  [[nodiscard]] std::size_t trigger_from(std::size_t begin, std::size_t end) const {
    std::size_t i = begin + 1;
    while (i < end && kind(i) != plus && kind(i) != minus && kind(i) != caret) {
      i = opens(kind(i)) ? items_[i].partner + 1 : i + 1;
    }
    return i;
  }

  // A part of a plan without the comments behind it, to which it returns.
  std::size_t part(std::size_t begin, std::size_t end, std::size_t indent) {
    while (items_[end - 1].is_comment) --end;
    flow(begin, end, indent);
    return end;
  }

  // The comments from `begin` on and what is between them and the token behind, which it returns.
  std::size_t same_line(std::size_t begin, std::size_t indent) {
    const std::size_t token = token_from(begin);
    for (std::size_t i = begin; i <= token; ++i) {
      gap(i, i, indent);
      if (i < token) write_item(i);
    }
    return token;
  }

  // Formulas, each on a line, the first where we are; returns what follows the last one. The full
  // stop is a part of the last formula of a plan.
  std::size_t formulas(std::size_t begin, std::size_t end, std::size_t indent) {
    while (true) {
      begin = formula(begin, end, indent);
      if (token_from(begin) >= end) return begin;
      begin = next_line(begin, indent, indent, EmptyLines::keep);
    }
  }

  // Its semicolon, or its last item if there is none before the next formula.
  [[nodiscard]] std::size_t end_of_formula(std::size_t begin, std::size_t end) const {
    const std::size_t last = find(semicolon, begin, end);
    for (std::size_t i = begin + 1; i < last; ++i) {
      if (items_[i].begins_formula) return i - 1;
      if (opens(items_[i].kind)) i = items_[i].partner;
    }
    return last;
  }

  // One formula with the semicolon or full stop behind it; returns what follows.
  std::size_t formula(std::size_t begin, std::size_t end, std::size_t indent) {
    std::size_t last = std::min(end_of_formula(begin, end) + 1, end);
    while (items_[last - 1].is_comment) --last;
    const TokenKind first = kind(begin);
    const bool is_statement = first == if_word || first == for_word || first == while_word;
    if (!is_statement || (is_on_one_line(begin, last) && fits(begin, last, column_))) {
      flow(begin, last, indent + kIndent);
      return last;
    }
    std::size_t i = block(begin, indent);
    while (i < last && (kind(token_from(i)) == elif_word || kind(token_from(i)) == else_word)) {
      i = block(same_line(i, indent), indent);
    }
    // Without a semicolon the next token begins another formula.
    const TokenKind next = i < last ? kind(token_from(i)) : end_of_text;
    if (next != semicolon && next != stop && next != fork_and && next != fork_or) return i;
    for (; i < last; ++i) {
      gap(i, last, indent + kIndent);
      write_item(i);
    }
    return last;
  }

  // `if (c) {`, `else {` and the like with what is in the braces; returns what follows.
  std::size_t block(std::size_t begin, std::size_t indent) {
    const std::size_t inner = indent + kIndent;
    std::size_t brace_at = begin;
    while (brace_at + 1 < items_.size() && kind(brace_at) != open_brace) {
      brace_at = opens(kind(brace_at)) ? items_[brace_at].partner + 1 : brace_at + 1;
    }
    const std::size_t last = items_[brace_at].partner;
    flow(begin, brace_at + 1, inner);
    if (last > brace_at + 1) {
      std::size_t i = brace_at + 1;
      if (token_from(i) < last)
        i = formulas(next_line(i, inner, inner, EmptyLines::drop), last, inner);
      (void)next_line(i, inner, indent, EmptyLines::drop);
    }
    write_item(last);
    return last + 1;
  }

  std::vector<Item> items_;
  std::string out_;
  std::size_t column_ = 0;
  std::size_t line_ = 0;
  std::size_t line_begin_ = 0;
  std::vector<format::ColumnMark> marks_;
};

// The same tokens and comments: nothing has been lost.
bool is_same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::ranges::equal(a, b, {}, &Item::text, &Item::text);
}

}  // namespace

Result<std::string> format_agent(const SourcePtr& source) {
  Diagnostics diagnostics;
  const ast::File file = parse_agent(source, diagnostics);
  if (diagnostics.has_errors()) return diagnostics;
  const std::vector<Item> items = format::items_of(file);
  std::string text = Formatter(items).run();
  // Line breaks matter where a semicolon is missing, so parse the result and compare.
  Diagnostics mistakes;
  const ast::File formatted =
      parse_agent(std::make_shared<const Source>(source->name(), text), mistakes);
  if (mistakes.has_errors() || print(file) != print(formatted) ||
      !is_same(items, format::items_of(formatted))) {
    diagnostics.error(source->name(), "its layout would change the program: it stays as it is",
                      "this is a mistake of ours; please report it with the file");
    return diagnostics;
  }
  return text;
}

}  // namespace jaywalk
