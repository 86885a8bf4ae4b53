// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/format/formatter_items.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "interpreter/support/diagnostics.h"
#include "interpreter/support/text.h"

namespace jaywalk::format {
namespace {

using enum TokenKind;

/// Splits a text into tokens and the comments between them.
class Splitter {
 public:
  explicit Splitter(const SourcePtr& source) : source_(source), text_(source->text()) {}

  std::vector<Item> run() {
    Diagnostics ignored;
    for (const Token& token : tokenize(source_, ignored)) {
      read_gap(token.span.begin);
      if (token.kind == end_of_text) break;
      add({.kind = token.kind, .text = source_->text(token.span)}, token.span.end);
    }
    return std::move(items_);
  }

 private:
  void read_gap(std::size_t end) {
    while (at_ < end) {
      const char c = text_[at_];
      if (c != '/') {
        breaks_ += c == '\n' ? 1 : 0;
        ++at_;
        continue;
      }
      const bool is_line = text_[at_ + 1] == '/';
      std::size_t last = is_line ? text_.find('\n', at_) : text_.find("*/", at_ + 2) + 2;
      last = std::min(last, end);
      std::string_view comment = text_.substr(at_, last - at_);
      while (is_line &&
             (comment.back() == ' ' || comment.back() == '\t' || comment.back() == '\r')) {
        comment.remove_suffix(1);
      }
      add({.text = comment, .is_comment = true, .is_line_comment = is_line}, last);
    }
  }

  void add(Item item, std::size_t end) {
    item.breaks_before = std::min(breaks_, 2);
    const auto begin = static_cast<std::uint32_t>(item.text.data() - text_.data());
    item.column = source_->position(begin).column - 1;
    items_.push_back(item);
    breaks_ = 0;
    at_ = end;
  }

  SourcePtr source_;
  std::string_view text_;
  std::vector<Item> items_;
  std::size_t at_ = 0;
  int breaks_ = 0;
};

bool is_operand_end(TokenKind kind) {
  switch (kind) {
    case atom:
    case variable:
    case number:
    case string:
    case true_word:
    case false_word:
    case begin_word:
    case end_word:
    case close:
    case close_list:
      return true;
    default:
      return false;
  }
}

bool is_open(TokenKind kind) {
  return kind == open || kind == body_open || kind == open_list || kind == open_brace;
}

bool is_close(TokenKind kind) { return kind == close || kind == close_list || kind == close_brace; }

bool is_name(TokenKind kind) {
  return kind == atom || kind == variable || kind == begin_word || kind == end_word;
}

/// Operators that stand before their operand, without a blank. `+` and `-` may be binary, too.
bool is_prefix(TokenKind kind) {
  switch (kind) {
    case bang:
    case double_bang:
    case question:
    case plus_plus:
    case minus_minus:
    case minus_plus:
    case plus_less:
    case plus_greater:
    case caret:
    case tilde:
    case at:
      return true;
    default:
      return false;
  }
}

/// Whether two tokens without a blank between them are still these two.
bool stay_apart(std::string_view before, std::string_view after) {
  const auto source =
      std::make_shared<const Source>("pair", std::string(before) + std::string(after));
  Diagnostics ignored;
  const std::vector<Token> tokens = tokenize(source, ignored);
  return tokens.front().span.end == before.size();
}

/// Goes through the tokens once, with the brackets that are open.
class Spacing {
 public:
  explicit Spacing(std::vector<Item>& items) : items_(items) {}

  void run() {
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (!items_[i].is_comment) visit(i);
    }
  }

 private:
  [[nodiscard]] bool in_list() const {
    return !open_.empty() && items_[open_.back()].kind == open_list;
  }

  void visit(std::size_t index) {
    Item& item = items_[index];
    if (is_close(item.kind) && !open_.empty()) {
      item.partner = open_.back();
      items_[open_.back()].partner = index;
      open_.pop_back();
    }
    const bool is_tail = item.kind == bar && in_list();
    if (before_ != nullptr) {
      item.blank_before = wants_blank(*before_, item, is_tail);
      if (!item.blank_before) item.blank_before = !stay_apart(before_->text, item.text);
      item.may_break = before_->kind == comma || before_->kind == semicolon ||
                       before_->kind == ampersand || (before_->kind == bar && !before_is_tail_);
    }
    note_prefix(item);
    before_is_tail_ = is_tail;
    before_ = &item;
    if (is_open(item.kind)) open_.push_back(index);
  }

  // A label ends where the trigger begins, so that `@a +!g` is no sum.
  void note_prefix(const Item& item) {
    const bool is_sign = item.kind == plus || item.kind == minus;
    const bool begins_trigger = labelled_ && label_depth_ == open_.size();
    const bool is_unary = before_ == nullptr || !is_operand_end(before_->kind) || begins_trigger;
    before_is_prefix_ = is_prefix(item.kind) || (is_sign && is_unary);
    if (item.kind == at) {
      labelled_ = true;
      label_depth_ = open_.size();
    } else if (begins_trigger && (is_sign || item.kind == caret)) {
      labelled_ = false;
    }
  }

  [[nodiscard]] bool wants_blank(const Item& before, const Item& item, bool is_tail) const {
    if (before_is_prefix_ || is_tail || before_is_tail_) return false;
    if (before.kind == open_brace) return item.kind != close_brace;
    if (is_open(before.kind) || before.kind == double_colon) return false;
    switch (item.kind) {
      case close:
      case close_list:
      case comma:
      case semicolon:
      case stop:
        return false;
      case double_colon:
      case open:
      case body_open:
        return !is_name(before.kind);
      case open_list:
        return !is_name(before.kind) && before.kind != close && before.kind != true_word &&
               before.kind != false_word;
      default:
        return true;
    }
  }

  std::vector<Item>& items_;
  std::vector<std::size_t> open_;
  const Item* before_ = nullptr;
  bool before_is_prefix_ = false;
  bool before_is_tail_ = false;
  bool labelled_ = false;
  std::size_t label_depth_ = 0;
};

/// Finds the formulas that follow another one without a semicolon. Nothing nests deeper than the
/// parser allows.
class Followers {
 public:
  explicit Followers(const ast::File& file) : text_(file.source->text()) {
    components(file.components);
  }

  /// The first characters of all formulas except for the first one of each body.
  [[nodiscard]] const std::set<const char*>& begins() const { return begins_; }

 private:
  void components(std::span<const ast::Component> components) {
    for (const ast::Component& component : components) {
      if (component.literal != nullptr) node(*component.literal);
      if (component.body != nullptr) node(*component.body);
      if (component.plan != nullptr) plan(*component.plan);
      this->components(component.inner);
    }
  }

  void plan(const ast::Plan& plan) {
    node(*plan.trigger.literal);
    if (plan.context != nullptr) node(*plan.context);
    if (plan.goal_condition != nullptr) node(*plan.goal_condition);
    formulas(plan.body);
    for (const ast::Plan* subplan : plan.subplans) this->plan(*subplan);
  }

  void node(const ast::Node& node) {
    for (const ast::Node* part : node.args) this->node(*part);
    formulas(node.formulas);
    if (node.plan != nullptr) plan(*node.plan);
    if (node.tail != nullptr) this->node(*node.tail);
    if (node.annots != nullptr) this->node(*node.annots);
  }

  // Whatever stands before a formula, a semicolon or not, as the token before it shows.
  void formulas(std::span<const ast::Formula> formulas) {
    for (const ast::Formula& formula : formulas) {
      if (&formula != &formulas.front()) begins_.insert(text_.data() + formula.span.begin);
      node(*formula.node);
    }
  }

  std::string_view text_;
  std::set<const char*> begins_;
};

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

std::vector<Item> items_of(const ast::File& file) {
  std::vector<Item> items = Splitter(file.source).run();
  Spacing(items).run();
  const Followers followers(file);
  TokenKind before = end_of_text;
  for (Item& item : items) {
    if (item.is_comment) continue;
    item.begins_formula = item.breaks_before > 0 && before != semicolon &&
                          followers.begins().contains(item.text.data());
    before = item.kind;
  }
  return items;
}

std::string with_columns(std::string text, std::vector<ColumnMark> marks, std::size_t width) {
  return Columns(text, std::move(marks), width).run();
}

}  // namespace jaywalk::format
