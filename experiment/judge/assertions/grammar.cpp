// SPDX-License-Identifier: Apache-2.0
// The grammar of assertions' expressions, in Boost.Spirit X3 over characters. Its actions put nodes
// on a stack in a Builder; there are no attributes. It decides by the next character or word and
// then expects what must follow, so that it never goes back and every failure is an error.

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include <boost/spirit/home/x3.hpp>
#include <fmt/format.h>

#include "experiment/judge/assertions/expression.h"
#include "interpreter/support/text.h"

namespace jaywalk::stl {
namespace {

namespace x3 = boost::spirit::x3;

using Iterator = const char*;

constexpr std::array<std::string_view, 19> kReserved = {
    "and",          "or",    "not",   "implies", "always", "eventually", "once",
    "historically", "until", "since", "forall",  "exists", "true",       "false",
    "inf",          "abs",   "min",   "max",     "happens"};

/// Letters, digits and `_`.
bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Keywords, which are no names.
bool is_reserved(std::string_view word) {
  return std::find(kReserved.begin(), kReserved.end(), word) != kReserved.end();
}

/// A hint on how to write an operator of another language here; empty if it is not known.
std::string hint_for(std::string_view rest) {
  struct Habit {
    std::string_view sign;
    std::string_view hint;
  };
  static constexpr std::array kHabits = {
      Habit{"&&", "write 'and'"},
      Habit{"&", "write 'and'"},
      Habit{"||", "write 'or'"},
      Habit{"|", "write 'or'"},
      Habit{"!=", "compare two numbers, as in ttc != 0"},
      Habit{"!", "write 'not'"},
      Habit{"->", "write '=>'"},
      Habit{"==", "compare two numbers, as in ttc == 0"},
      Habit{"=>", "a condition stands on either side of '=>'"},
      Habit{"=", "write '=='"},
      Habit{"<", "write 'a < b and b < c'"},
      Habit{">", "write 'a > b and b > c'"},
      Habit{"until", "put 'p until q' into parentheses before it is combined further"},
      Habit{"since", "put 'p since q' into parentheses before it is combined further"},
  };
  for (const Habit& habit : kHabits) {
    if (rest.starts_with(habit.sign)) return std::string(habit.hint);
  }
  return {};
}

/// A keyword that the last word of a text may be a slip for; empty if there is none.
std::string keyword_hint(std::string_view before) {
  while (!before.empty() && !is_word_character(before.back())) before.remove_suffix(1);
  std::size_t begin = before.size();
  while (begin > 0 && is_word_character(before[begin - 1])) --begin;
  const std::string name(before.substr(begin));
  if (name.empty() || is_reserved(name)) return {};
  const std::vector<std::string> words(kReserved.begin(), kReserved.end());
  return did_you_mean(name, words);
}

/// Nodes under construction: each action takes operands from the stack and puts its node there.
class Builder {
 public:
  explicit Builder(const ExpressionText& text) : begin_(text.text.data()) {}

  struct Open {
    NodeKind kind;
    std::uint32_t begin;
    bool windowed = false;
  };

  void leaf(NodeKind kind, Iterator from, Iterator to, double number) {
    Node node;
    node.kind = kind;
    node.number = number;
    node.name.assign(from, to);
    node.span = {offset(from), offset(to)};
    push(std::move(node));
  }
  void begin(NodeKind kind, Iterator from) { open_.push_back({kind, offset(from)}); }
  void window() { open_.back().windowed = true; }
  void end(Iterator to) {
    const Open open = open_.back();
    open_.pop_back();
    Node node;
    node.kind = open.kind;
    const auto count = static_cast<std::size_t>(operand_count(open.kind));
    for (std::size_t i = count; i-- > 0;) node.operands[i] = pop();
    // The window was written before the last operand, after the first.
    if (open.windowed) {
      const NodeId to_bound = window_.back();
      window_.pop_back();
      node.bounds = {window_.back(), to_bound};
      window_.pop_back();
    }
    node.span = {open.begin, offset(to)};
    if (count == 2) node.span.begin = nodes_[node.operands[0]].span.begin;
    push(std::move(node));
  }
  void bound() { window_.push_back(pop()); }

  bool enter() { return ++depth_ <= kMaxExpressionDepth; }
  void leave() { --depth_; }
  [[nodiscard]] bool too_deep() const { return depth_ > kMaxExpressionDepth; }
  [[nodiscard]] std::uint32_t offset(Iterator at) const {
    return static_cast<std::uint32_t>(at - begin_);
  }
  [[nodiscard]] std::vector<Node> take() { return std::move(nodes_); }

 private:
  void push(Node node) {
    stack_.push_back(static_cast<NodeId>(nodes_.size()));
    nodes_.push_back(std::move(node));
  }
  NodeId pop() {
    const NodeId top = stack_.back();
    stack_.pop_back();
    return top;
  }

  Iterator begin_;
  std::vector<Node> nodes_;
  std::vector<NodeId> stack_;
  std::vector<NodeId> window_;
  std::vector<Open> open_;
  int depth_ = 0;
};

struct BuilderTag;

template <class Context>
Builder& builder_of(const Context& context) {
  return x3::get<BuilderTag>(context);
}

void skip_blanks(Iterator& first, Iterator last) {
  while (first != last && (*first == ' ' || *first == '\t' || *first == '\n' || *first == '\r')) {
    ++first;
  }
}

/// The word at `first`, with dots (`nearest.ttc`); empty if there is none.
std::string_view word_at(Iterator first, Iterator last) {
  if (first == last || !is_word_character(*first) || (*first >= '0' && *first <= '9')) return {};
  Iterator end = first;
  while (end != last && (is_word_character(*end) ||
                         (*end == '.' && end + 1 != last && is_word_character(end[1])))) {
    ++end;
  }
  return {first, static_cast<std::size_t>(end - first)};
}

/// Base of the terminals: without attribute, blanks before them skipped.
template <class Derived>
struct Terminal : x3::parser<Derived> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& /*rule*/,
             Attribute& /*attribute*/) const {
    Iterator at = first;
    skip_blanks(at, last);
    if (!static_cast<const Derived*>(this)->match(at, last, builder_of(context))) return false;
    first = at;
    return true;
  }
};

/// A sign or a keyword; beginning a node of that kind, if there is one.
struct Word : Terminal<Word> {
  std::string_view word;
  std::optional<NodeKind> begins;

  explicit Word(std::string_view text, std::optional<NodeKind> kind = {})
      : word(text), begins(kind) {}

  bool match(Iterator& at, Iterator last, Builder& builder) const {
    const Iterator from = at;
    if (is_word_character(word.front())) {
      if (word_at(at, last) != word) return false;
    } else {
      if (!std::string_view(at, static_cast<std::size_t>(last - at)).starts_with(word))
        return false;
      // `<` is not the beginning of `<=`.
      if (word.size() == 1 && (word == "<" || word == ">") && at + 1 != last && at[1] == '=') {
        return false;
      }
    }
    at += word.size();
    if (begins) builder.begin(*begins, from);
    return true;
  }
};

struct Number : Terminal<Number> {
  bool match(Iterator& at, Iterator last, Builder& builder) const {
    const Iterator from = at;
    if (word_at(at, last) == "inf") {
      at += 3;
      builder.leaf(NodeKind::number, from, at, std::numeric_limits<double>::infinity());
      return true;
    }
    if (at == last || ((*at < '0' || *at > '9') && *at != '.')) return false;
    double value = 0;
    const auto [end, error] = std::from_chars(at, last, value);
    // `12mph` is neither a number nor a name.
    if (error != std::errc{} || (end != last && (is_word_character(*end) || *end == '.'))) {
      return false;
    }
    at = end;
    builder.leaf(NodeKind::number, from, at, value);
    return true;
  }
};

struct Truth : Terminal<Truth> {
  bool match(Iterator& at, Iterator last, Builder& builder) const {
    const std::string_view word = word_at(at, last);
    if (word != "true" && word != "false") return false;
    const Iterator from = at;
    at += word.size();
    builder.leaf(NodeKind::truth, from, at, word == "true" ? 1 : 0);
    return true;
  }
};

/// A name that is not a keyword, with at most one dot.
struct Name : Terminal<Name> {
  NodeKind kind;
  explicit Name(NodeKind node) : kind(node) {}

  bool match(Iterator& at, Iterator last, Builder& builder) const {
    const std::string_view word = word_at(at, last);
    if (word.empty() || is_reserved(word)) return false;
    const Iterator from = at;
    at += word.size();
    builder.leaf(kind, from, at, 0);
    return true;
  }
};

/// Matches nothing, but makes the builder go on.
struct Step : x3::parser<Step> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  void (*action)(Builder&, Iterator);

  explicit Step(void (*step)(Builder&, Iterator)) : action(step) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& /*last*/, const Context& context,
             RuleContext& /*rule*/, Attribute& /*attribute*/) const {
    action(builder_of(context), first);
    return true;
  }
};

/// Limits how deep its operand may be nested in itself.
template <class Subject>
struct Nested : x3::unary_parser<Subject, Nested<Subject>> {
  using base_type = x3::unary_parser<Subject, Nested<Subject>>;
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  explicit Nested(const Subject& enclosed) : base_type(enclosed) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute& attribute) const {
    Builder& builder = builder_of(context);
    if (!builder.enter()) return false;
    const bool matched = this->subject.parse(first, last, context, rule, attribute);
    if (!builder.too_deep()) builder.leave();
    return matched;
  }
};

template <class Subject>
auto nested(const Subject& subject) {
  return Nested<typename x3::extension::as_parser<Subject>::value_type>(x3::as_parser(subject));
}

}  // namespace
}  // namespace jaywalk::stl

// The names of parsers in diagnostics, "expected …".
namespace boost::spirit::x3 {
template <>
struct get_info<jaywalk::stl::Word> {
  using result_type = std::string;
  std::string operator()(const jaywalk::stl::Word& word) const {
    return fmt::format("'{}'", word.word);
  }
};
template <>
struct get_info<jaywalk::stl::Name> {
  using result_type = std::string;
  std::string operator()(const jaywalk::stl::Name& name) const {
    return name.kind == jaywalk::stl::NodeKind::event ? "the kind of an event" : "a signal";
  }
};
template <class Subject>
struct get_info<jaywalk::stl::Nested<Subject>> {
  using result_type = std::string;
  std::string operator()(const jaywalk::stl::Nested<Subject>& nested) const {
    return what(nested.subject);
  }
};
}  // namespace boost::spirit::x3

namespace jaywalk::stl {
namespace {

Word word(std::string_view text) { return Word(text); }
Word word(std::string_view text, NodeKind begins) { return Word(text, begins); }

// The node that was begun last ends here.
const Step end_node([](Builder& builder, Iterator at) { builder.end(at); });
const Step bound([](Builder& builder, Iterator) { builder.bound(); });
const Step windowed([](Builder& builder, Iterator) { builder.window(); });

// The names are those that diagnostics use.
const x3::rule<class ImplicationRule> implication = "a condition";
const x3::rule<class DisjunctionRule> disjunction = "a condition";
const x3::rule<class ConjunctionRule> conjunction = "a condition";
const x3::rule<class BindingRule> binding = "a condition";
const x3::rule<class PrefixedRule> prefixed = "a condition";
const x3::rule<class ComparisonRule> comparison = "a condition";
const x3::rule<class SumRule> sum = "a number or a signal";
const x3::rule<class ProductRule> product = "a number or a signal";
const x3::rule<class FactorRule> factor = "a number or a signal";
const x3::rule<class WindowRule> window = "a window";

const auto implication_def = disjunction >> -((word("=>", NodeKind::implication) |
                                               word("implies", NodeKind::implication)) >
                                              nested(implication) > end_node);
const auto disjunction_def = conjunction >>
                             *(word("or", NodeKind::disjunction) > conjunction > end_node);
const auto conjunction_def = binding >> *(word("and", NodeKind::conjunction) > binding > end_node);
const auto binding_def = prefixed >>
                         -(((word("until", NodeKind::until) | word("since", NodeKind::since)) >>
                            -window) > prefixed > end_node);
const auto prefixed_def = nested(
    (word("not", NodeKind::negation) > prefixed > end_node) |
    (((word("always", NodeKind::always) | word("eventually", NodeKind::eventually) |
       word("historically", NodeKind::historically) | word("once", NodeKind::once)) >>
      -window) > prefixed > end_node) |
    ((word("forall", NodeKind::for_all) | word("exists", NodeKind::exists)) > prefixed > end_node) |
    comparison);
const auto compared = word("<=", NodeKind::less_equal) | word("<", NodeKind::less) |
                      word(">=", NodeKind::greater_equal) | word(">", NodeKind::greater) |
                      word("==", NodeKind::equal) | word("!=", NodeKind::not_equal);
const auto comparison_def = sum >> -(compared > sum > end_node);
const auto sum_def = product >> *((word("+", NodeKind::add) | word("-", NodeKind::subtract)) >
                                  product > end_node);
const auto product_def = factor >> *((word("*", NodeKind::multiply) | word("/", NodeKind::divide)) >
                                     factor > end_node);
const auto factor_def = (word("-", NodeKind::negative) > nested(factor) > end_node) | Number{} |
                        Truth{} |
                        (word("abs", NodeKind::absolute) > word("(") > sum > word(")") > end_node) |
                        ((word("min", NodeKind::minimum) | word("max", NodeKind::maximum)) >
                         word("(") > sum > word(",") > sum > word(")") > end_node) |
                        (word("happens") > word("(") > Name(NodeKind::event) > word(")")) |
                        Name(NodeKind::signal) | (word("(") > nested(implication) > word(")"));
const auto window_def = word("[") > sum > bound > word(",") > sum > bound > word("]") > windowed;

BOOST_SPIRIT_DEFINE(implication, disjunction, conjunction, binding, prefixed, comparison, sum,
                    product, factor, window)

void report_syntax_error(const ExpressionText& text, Iterator where, std::string_view expected,
                         bool too_deep, Diagnostics& diagnostics) {
  const Iterator last = text.text.data() + text.text.size();
  skip_blanks(where, last);
  const auto offset = static_cast<std::uint32_t>(where - text.text.data());
  const std::string_view rest(where, static_cast<std::size_t>(last - where));
  if (too_deep) {
    text.error(diagnostics, {offset, offset + 1},
               fmt::format("nested more than {} levels deep", kMaxExpressionDepth));
    return;
  }
  std::string_view found = word_at(where, last);
  if (found.empty() && !rest.empty()) {
    // A number or a sign, whole characters of UTF-8.
    std::size_t length = 1;
    while (length < rest.size() && !begins_character(rest[length])) {
      ++length;
    }
    if (is_word_character(rest[0])) {
      while (length < rest.size() && (is_word_character(rest[length]) || rest[length] == '.')) {
        ++length;
      }
    }
    found = rest.substr(0, length);
  }
  const std::string_view before = std::string_view(text.text).substr(0, offset);
  std::string hint = rest.starts_with('>') && before.ends_with('-') ? "write '=>'" : hint_for(rest);
  if (hint.empty() && !rest.empty()) {
    hint = keyword_hint(before);
  }
  const auto end = offset + static_cast<std::uint32_t>(std::max<std::size_t>(found.size(), 1));
  text.error(diagnostics, {offset, end},
             rest.empty() ? fmt::format("expected {}, found the end", expected)
                          : fmt::format("expected {}, found '{}'", expected, found),
             std::move(hint));
}

}  // namespace

std::optional<Expression> parse(ExpressionText text, Diagnostics& diagnostics) {
  if (text.text.size() > kMaxExpressionBytes) {
    text.error(diagnostics, {0, 1},
               fmt::format("an expression of more than {} bytes", kMaxExpressionBytes));
    return std::nullopt;
  }
  Builder builder(text);
  Iterator first = text.text.data();
  const Iterator last = first + text.text.size();
  try {
    const bool matched =
        x3::parse(first, last, x3::with<BuilderTag>(std::ref(builder))[implication]);
    skip_blanks(first, last);
    if (!matched || first != last) {
      report_syntax_error(text, first, matched ? "an operator or the end" : "a condition",
                          builder.too_deep(), diagnostics);
      return std::nullopt;
    }
  } catch (const x3::expectation_failure<Iterator>& failure) {
    report_syntax_error(text, failure.where(), failure.which(), builder.too_deep(), diagnostics);
    return std::nullopt;
  }
  Expression expression;
  expression.nodes = builder.take();
  expression.root = static_cast<NodeId>(expression.nodes.size() - 1);
  expression.written = std::move(text);
  return expression;
}

}  // namespace jaywalk::stl
