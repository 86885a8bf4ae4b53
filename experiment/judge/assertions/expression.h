// SPDX-License-Identifier: Apache-2.0
#pragma once

// Discrete-time signal temporal logic (STL) over logged signals, as people write it in assertions:
//
//   eventually (in_lane and ttc <= 1) => always[0, 3] av.deceleration <= 4
//
// This file has its syntax; robustness.h its meaning, docs/reference/assertions.md is the
// reference. A text is parsed (grammar.cpp), then its names are resolved against a vocabulary and
// its types checked (resolve.cpp). The result is immutable and shared by all threads.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk::stl {

enum class NodeKind : std::uint8_t {
  // Numbers
  number,
  signal,  // a number or a condition, as the vocabulary says
  negative,
  add,
  subtract,
  multiply,
  divide,
  absolute,
  minimum,
  maximum,
  // Conditions
  truth,  // `true`, `false`: number is 1 or 0
  event,  // happens(kind)
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  negation,
  conjunction,
  disjunction,
  implication,
  always,
  eventually,
  historically,
  once,
  until,
  since,
  for_all,  // for each road user
  exists,   // for some road user
};

/// The owner of a signal.
enum class Owner : std::uint8_t { test, av, self, nearest, named };

using NodeId = std::uint32_t;

/// A window of time in seconds, both ends included; relative to now, into the future for `always`,
/// `eventually` and `until`, into the past for the others.
struct Window {
  double from_s = 0;
  double to_s = 0;  // may be infinite
};

struct Node {
  NodeKind kind = NodeKind::number;
  std::array<NodeId, 2> operands{};
  double number = 0;
  /// The window of a temporal operator; parsed as two numbers, `bounds`, folded when names are
  /// resolved.
  Window window;
  std::optional<std::array<NodeId, 2>> bounds;
  /// The name of a signal or event as written, `nearest.ttc`, and the signal that it refers to.
  std::string name;
  Owner owner = Owner::self;
  std::uint32_t signal = 0;
  /// Bytes of the expression's text.
  Span span;
};

/// How many operands a kind has.
[[nodiscard]] int operand_count(NodeKind kind);
[[nodiscard]] bool is_comparison(NodeKind kind);
[[nodiscard]] bool is_temporal(NodeKind kind);

/// An expression's text and where in a file each of its bytes was written.
struct ExpressionText {
  std::string text;
  /// The file, and the place in it of each byte of `text`; empty if the text is not from a file.
  SourcePtr source;
  std::vector<std::uint32_t> offsets;
  /// The subject of diagnostics if there is no file.
  std::string subject;

  void error(Diagnostics& diagnostics, Span span, std::string message, std::string hint = {}) const;
  void warning(Diagnostics& diagnostics, Span span, std::string code, std::string message,
               std::string hint = {}) const;
};

/// A text that stands in a file as it is, from that offset on.
[[nodiscard]] ExpressionText expression_text(SourcePtr source);

class Vocabulary;

/// Nodes in the order in which they were completed: operands come before their operators.
class Expression {
 public:
  std::vector<Node> nodes;
  NodeId root = 0;
  ExpressionText written;

  [[nodiscard]] const Node& node(NodeId id) const { return nodes[id]; }
  /// Whether it is about a road user that no `forall` or `exists` introduces.
  [[nodiscard]] bool is_about_one() const { return about_one_; }

 private:
  friend std::optional<Expression> resolve(Expression parsed, const Vocabulary& vocabulary,
                                           const std::map<std::string, double>& parameters,
                                           Diagnostics& diagnostics);
  bool about_one_ = false;
};

inline constexpr std::size_t kMaxExpressionBytes = 4000;
inline constexpr int kMaxExpressionDepth = 100;

/// Parses without resolving names. No value after adding errors.
[[nodiscard]] std::optional<Expression> parse(ExpressionText text, Diagnostics& diagnostics);

enum class SignalType : std::uint8_t { number, condition };

/// A signal that expressions can name: `name` if it belongs to a road user or the test, `av.name`
/// if to the automated vehicle.
struct SignalName {
  std::string_view name;
  Owner owner = Owner::self;  // self, av or test
  SignalType type = SignalType::number;
};

class Vocabulary {
 public:
  explicit Vocabulary(std::span<const SignalName> signals) : signals_(signals) {}
  [[nodiscard]] std::span<const SignalName> signals() const { return signals_; }

 private:
  std::span<const SignalName> signals_;
};

/// Resolves names to signals and parameters, folds windows, checks that conditions and numbers
/// stand where they belong. The whole has to be a condition. No value after adding errors.
[[nodiscard]] std::optional<Expression> resolve(Expression parsed, const Vocabulary& vocabulary,
                                                const std::map<std::string, double>& parameters,
                                                Diagnostics& diagnostics);

}  // namespace jaywalk::stl
