// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/judge/assertions/expression.h"

namespace jaywalk::stl {
namespace {

/// As many names as a hint lists.
constexpr std::size_t kFew = 10;

std::string_view described(SignalType type) {
  return type == SignalType::number ? "a number" : "a condition";
}

/// Gives every node its type, in their order: operands come first.
class Resolver {
 public:
  Resolver(Expression& expression, const Vocabulary& vocabulary,
           const std::map<std::string, double>& parameters, Diagnostics& diagnostics)
      : expression_(expression),
        vocabulary_(vocabulary),
        parameters_(parameters),
        diagnostics_(diagnostics) {}

  void run() {
    for (Node& node : expression_.nodes) {
      types_.push_back(resolve(node));
      about_one_.push_back(is_about_one(node));
      quantified_.push_back(is_quantified(node));
    }
    // A whole assertion is something that holds or not.
    expect(expression_.root, SignalType::condition);
  }

  [[nodiscard]] bool about_one() const { return about_one_[expression_.root]; }

 private:
  void error(const Node& node, std::string message, std::string hint = {}) {
    expression_.written.error(diagnostics_, node.span, std::move(message), std::move(hint));
  }

  void expect(NodeId id, SignalType type) {
    const Node& node = expression_.node(id);
    if (!types_[id] || *types_[id] == type) return;  // a mistake in it is reported already
    error(node, fmt::format("expected {}, found {}", described(type), described(*types_[id])),
          type == SignalType::condition ? "compare it with something, as in ttc <= 1" : "");
  }

  void expect_all(const Node& node, SignalType type) {
    const auto count = static_cast<std::size_t>(operand_count(node.kind));
    for (std::size_t i = 0; i < count; ++i) expect(node.operands[i], type);
  }

  std::optional<SignalType> resolve(Node& node) {
    using enum NodeKind;
    switch (node.kind) {
      case number:
        return SignalType::number;
      case truth:
        return SignalType::condition;
      case signal:
        return resolve_signal(node);
      case event:
        split_event(node);
        return SignalType::condition;
      case negative:
      case add:
      case subtract:
      case multiply:
      case divide:
      case absolute:
      case minimum:
      case maximum:
        expect_all(node, SignalType::number);
        return SignalType::number;
      case less:
      case less_equal:
      case greater:
      case greater_equal:
      case equal:
      case not_equal:
        expect_all(node, SignalType::number);
        return SignalType::condition;
      case negation:
      case conjunction:
      case disjunction:
      case implication:
      case always:
      case eventually:
      case historically:
      case once:
      case until:
      case since:
      case for_all:
      case exists:
        expect_all(node, SignalType::condition);
        if (is_temporal(node.kind)) fold_window(node);
        if (quantifies(node) && quantified_[node.operands[0]]) {
          error(node, "forall or exists within another one",
                "the inner one is about all road users already");
        }
        return SignalType::condition;
    }
    return std::nullopt;
  }

  /// A parameter becomes a number, a signal gets its index.
  std::optional<SignalType> resolve_signal(Node& node) {
    if (const auto parameter = parameters_.find(node.name); parameter != parameters_.end()) {
      node.kind = NodeKind::number;
      node.number = parameter->second;
      return SignalType::number;
    }
    // `av.speed`, `nearest.ttc`, `a.distance` of a quantifier's `a`, or `distance` of the road user
    // at hand.
    const std::size_t dot = node.name.find('.');
    const std::string_view name =
        dot == std::string::npos ? node.name : std::string_view(node.name).substr(dot + 1);
    const std::string_view owner =
        dot == std::string::npos ? "" : std::string_view(node.name).substr(0, dot);
    const auto signals = vocabulary_.signals();
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (signals[i].name != name || !may_own(owner, signals[i].owner)) continue;
      node.signal = static_cast<std::uint32_t>(i);
      node.owner = owner_of(owner, signals[i].owner);
      if (node.owner == Owner::named) node.name = owner;
      return signals[i].type;
    }
    report_unknown(node, owner);
    return std::nullopt;
  }

  static bool may_own(std::string_view written, Owner owner) {
    if (owner == Owner::av) return written == "av";
    if (owner == Owner::test) return written.empty();
    return written != "av";
  }

  static Owner owner_of(std::string_view written, Owner owner) {
    if (owner != Owner::self || written.empty()) return owner;
    return written == "nearest" ? Owner::nearest : Owner::named;
  }

  void report_unknown(const Node& node, std::string_view owner) {
    std::vector<std::string> known;
    for (const SignalName& signal : vocabulary_.signals()) {
      if (!may_own(owner, signal.owner)) continue;
      known.push_back(owner.empty() ? std::string(signal.name)
                                    : fmt::format("{}.{}", owner, signal.name));
    }
    for (const auto& [parameter, value] : parameters_) known.push_back(parameter);
    std::string hint = did_you_mean(node.name, known);
    // `speeed` may have been meant as the vehicle's.
    if (hint.empty() && owner.empty()) {
      for (const SignalName& signal : vocabulary_.signals()) {
        if (signal.owner == Owner::av && signal.name == node.name) {
          hint = fmt::format("did you mean 'av.{}'?", node.name);
        }
      }
    }
    if (hint.empty() && !known.empty() && known.size() <= kFew) {
      hint = fmt::format("the signals here are {}", fmt::join(known, ", "));
    }
    if (hint.empty()) hint = "`jaywalk list signals` names them; 'parameters' adds numbers";
    error(node, fmt::format("unknown signal '{}'", node.name), std::move(hint));
  }

  /// The kind of an event is written without an owner.
  void split_event(Node& node) {
    node.owner = Owner::self;
    if (node.name.find('.') != std::string::npos) {
      error(node, fmt::format("expected the kind of an event, found '{}'", node.name),
            "happens(precondition) is about the road user at hand");
    }
  }

  void fold_window(Node& node) {
    node.window = {0, std::numeric_limits<double>::infinity()};
    if (!node.bounds) return;
    const auto from = constant((*node.bounds)[0]);
    const auto to = constant((*node.bounds)[1]);
    if (!from || !to) return;
    const Node& first = expression_.node((*node.bounds)[0]);
    // Written so that a NaN (0/0 of parameters) is refused, too.
    if (!(*from >= 0) || std::isinf(*from)) {
      error(first, fmt::format("expected a time of at least 0 s, found {}", *from));
    } else if (!(*to >= *from)) {
      error(expression_.node((*node.bounds)[1]),
            fmt::format("the window ends at {} s, before it begins at {} s", *to, *from));
    }
    node.window = {*from, *to};
  }

  std::optional<double> constant(NodeId id) {
    const Node& node = expression_.node(id);
    if (!types_[id]) return std::nullopt;
    if (const auto value = folded(id)) return value;
    error(node, "a window's bounds are numbers or parameters, in seconds");
    return std::nullopt;
  }

  /// The value of an expression of numbers and parameters; nothing if a signal is in it. Parameters
  /// have become numbers by now.
  [[nodiscard]] std::optional<double> folded(NodeId id) const {
    const Node& node = expression_.node(id);
    if (node.kind == NodeKind::number) return node.number;
    if (node.kind == NodeKind::signal || types_[id] != SignalType::number) return std::nullopt;
    const auto left = folded(node.operands[0]);
    if (node.kind == NodeKind::negative && left) return -*left;
    if (node.kind == NodeKind::absolute && left) return std::abs(*left);
    if (operand_count(node.kind) < 2 || !left) return std::nullopt;
    const auto right = folded(node.operands[1]);
    if (!right) return std::nullopt;
    switch (node.kind) {
      case NodeKind::add:
        return *left + *right;
      case NodeKind::subtract:
        return *left - *right;
      case NodeKind::multiply:
        return *left * *right;
      case NodeKind::divide:
        return *left / *right;
      case NodeKind::minimum:
        return std::min(*left, *right);
      case NodeKind::maximum:
        return std::max(*left, *right);
      default:
        return std::nullopt;
    }
  }

  static bool quantifies(const Node& node) {
    return node.kind == NodeKind::for_all || node.kind == NodeKind::exists;
  }

  [[nodiscard]] bool is_quantified(const Node& node) const {
    if (quantifies(node)) return true;
    const auto count = static_cast<std::size_t>(operand_count(node.kind));
    for (std::size_t i = 0; i < count; ++i) {
      if (quantified_[node.operands[i]]) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_about_one(const Node& node) const {
    // A quantifier binds the road user that its operand is about.
    if (quantifies(node)) return false;
    if (node.kind == NodeKind::event) return true;
    if (node.kind == NodeKind::signal) return node.owner == Owner::self;
    const auto count = static_cast<std::size_t>(operand_count(node.kind));
    for (std::size_t i = 0; i < count; ++i) {
      if (about_one_[node.operands[i]]) return true;
    }
    return false;
  }

  Expression& expression_;
  const Vocabulary& vocabulary_;
  const std::map<std::string, double>& parameters_;
  Diagnostics& diagnostics_;
  std::vector<std::optional<SignalType>> types_;
  std::vector<bool> about_one_;
  std::vector<bool> quantified_;
};

/// The place in the file of a span of the text.
SourceSpan place_of(const ExpressionText& text, Span span) {
  const auto at = [&](std::uint32_t offset) {
    // `offsets` maps the expression's characters to the file's: YAML may fold and escape them.
    if (text.offsets.empty()) return std::uint32_t{0};
    if (offset < text.offsets.size()) return text.offsets[offset];
    return text.offsets.back() + 1;
  };
  const std::uint32_t begin = at(span.begin);
  const std::uint32_t end = span.end > span.begin ? at(span.end - 1) + 1 : begin;
  return {text.source, {begin, std::max(begin, end)}};
}

}  // namespace

int operand_count(NodeKind kind) {
  using enum NodeKind;
  switch (kind) {
    case number:
    case signal:
    case truth:
    case event:
      return 0;
    case negative:
    case absolute:
    case negation:
    case always:
    case eventually:
    case historically:
    case once:
    case for_all:
    case exists:
      return 1;
    case add:
    case subtract:
    case multiply:
    case divide:
    case minimum:
    case maximum:
    case less:
    case less_equal:
    case greater:
    case greater_equal:
    case equal:
    case not_equal:
    case conjunction:
    case disjunction:
    case implication:
    case until:
    case since:
      return 2;
  }
  return 0;
}

bool is_comparison(NodeKind kind) { return kind >= NodeKind::less && kind <= NodeKind::not_equal; }

bool is_temporal(NodeKind kind) { return kind >= NodeKind::always && kind <= NodeKind::since; }

void ExpressionText::error(Diagnostics& diagnostics, Span span, std::string message,
                           std::string hint) const {
  if (source) {
    diagnostics.error(place_of(*this, span), std::move(message), std::move(hint));
  } else {
    diagnostics.error(subject, std::move(message), std::move(hint));
  }
}

void ExpressionText::warning(Diagnostics& diagnostics, Span span, std::string code,
                             std::string message, std::string hint) const {
  diagnostics.warning(place_of(*this, span), std::move(code), std::move(message), std::move(hint));
}

ExpressionText expression_text(SourcePtr source) {
  ExpressionText result;
  result.text = source->text();
  for (std::uint32_t i = 0; i < result.text.size(); ++i) result.offsets.push_back(i);
  result.source = std::move(source);
  return result;
}

std::optional<Expression> resolve(Expression parsed, const Vocabulary& vocabulary,
                                  const std::map<std::string, double>& parameters,
                                  Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  Resolver resolver(parsed, vocabulary, parameters, diagnostics);
  resolver.run();
  if (diagnostics.error_count() > errors) return std::nullopt;
  parsed.about_one_ = resolver.about_one();
  return parsed;
}

}  // namespace jaywalk::stl
