// SPDX-License-Identifier: Apache-2.0
#include "search/suts/scaling.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace jaywalk::search {
namespace {

using stl::Expression;
using stl::Node;
using stl::NodeId;
using stl::NodeKind;

/// From the least to the greatest of some values; what is undefined (inf - inf) has no bounds.
SignalRange spanning(std::initializer_list<double> values) {
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) return {};
  return {std::min(values), std::max(values)};
}

SignalRange product(SignalRange a, SignalRange b) {
  return spanning({a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most});
}

SignalRange quotient(SignalRange a, SignalRange b) {
  if (b.least <= 0 && b.most >= 0) return {};
  return product(a, {1 / b.most, 1 / b.least});
}

SignalRange magnitude(SignalRange a) {
  const bool has_zero = a.least <= 0 && a.most >= 0;
  const SignalRange ends = spanning({std::fabs(a.least), std::fabs(a.most)});
  return {has_zero ? 0 : ends.least, ends.most};
}

class Scaler {
 public:
  Scaler(const Expression& expression, std::span<const SignalRange> signals,
         Diagnostics& diagnostics)
      : expression_(expression), signals_(signals), diagnostics_(diagnostics) {}

  std::optional<Expression> run() {
    const std::size_t errors = diagnostics_.error_count();
    for (const Node& node : expression_.nodes) {
      ranges_.push_back(range_of(node));
      places_.push_back(is_comparison(node.kind) ? add_comparison(node) : add(moved(node)));
    }
    if (diagnostics_.error_count() > errors) return std::nullopt;
    Expression result = expression_;
    result.nodes = std::move(nodes_);
    result.root = places_[expression_.root];
    return result;
  }

 private:
  /// The bounds of a number; conditions have none.
  [[nodiscard]] SignalRange range_of(const Node& node) const {
    using enum NodeKind;
    if (node.kind == number) return {node.number, node.number};
    if (node.kind == signal) return signals_[node.signal];
    if (operand_count(node.kind) == 0) return {};
    const SignalRange a = ranges_[node.operands[0]];
    if (node.kind == negative) return {-a.most, -a.least};
    if (node.kind == absolute) return magnitude(a);
    if (operand_count(node.kind) == 1) return {};
    const SignalRange b = ranges_[node.operands[1]];
    switch (node.kind) {
      case add:
        return {a.least + b.least, a.most + b.most};
      case subtract:
        return {a.least - b.most, a.most - b.least};
      case multiply:
        return product(a, b);
      case divide:
        return quotient(a, b);
      case minimum:
        return {std::min(a.least, b.least), std::min(a.most, b.most)};
      case maximum:
        return {std::max(a.least, b.least), std::max(a.most, b.most)};
      default:
        return {};
    }
  }

  NodeId add(Node node) {
    nodes_.push_back(std::move(node));
    return static_cast<NodeId>(nodes_.size() - 1);
  }

  NodeId add_number(double value, Span span) {
    return add({.kind = NodeKind::number, .number = value, .span = span});
  }

  /// The node with its operands where they are now. Its window is folded: the nodes of the window's
  /// bounds are not needed.
  [[nodiscard]] Node moved(Node node) const {
    const auto count = static_cast<std::size_t>(operand_count(node.kind));
    for (std::size_t i = 0; i < count; ++i) node.operands[i] = places_[node.operands[i]];
    node.bounds.reset();
    return node;
  }

  /// `a < b` becomes `(a - b) / widest < 0`.
  NodeId add_comparison(const Node& comparison) {
    const SignalRange a = ranges_[comparison.operands[0]];
    const SignalRange b = ranges_[comparison.operands[1]];
    const double widest = magnitude(SignalRange{a.least - b.most, a.most - b.least}).most;
    if (!std::isfinite(widest)) {
      expression_.written.error(diagnostics_, comparison.span,
                                "how far apart the two sides can be is not known",
                                "a signal in it has no range, or is divided by what may be 0");
      return 0;
    }
    Node node = moved(comparison);
    if (widest == 0) return add(std::move(node));
    const NodeId difference =
        add({.kind = NodeKind::subtract, .operands = node.operands, .span = comparison.span});
    const NodeId unit = add_number(widest, comparison.span);
    const NodeId share =
        add({.kind = NodeKind::divide, .operands = {difference, unit}, .span = comparison.span});
    node.operands = {share, add_number(0, comparison.span)};
    return add(std::move(node));
  }

  const Expression& expression_;
  std::span<const SignalRange> signals_;
  Diagnostics& diagnostics_;
  std::vector<SignalRange> ranges_;
  /// Where each node is in the new expression.
  std::vector<NodeId> places_;
  std::vector<Node> nodes_;
};

}  // namespace

std::optional<Expression> scaled(const Expression& expression, std::span<const SignalRange> signals,
                                 Diagnostics& diagnostics) {
  return Scaler(expression, signals, diagnostics).run();
}

}  // namespace jaywalk::search
