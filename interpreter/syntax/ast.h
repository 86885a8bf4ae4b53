// SPDX-License-Identifier: Apache-2.0
#pragma once

// The syntax tree of AgentSpeak programs, as written: nothing is resolved, renamed or desugared
// here but the statements that Jason itself turns into internal actions. One Node type serves
// terms and formulas alike, since in Jason every term may be a logical expression. Nodes live in
// an Arena and are trivially destructible; texts point into the Source or the Arena.

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>
#include <string_view>

#include <jaywalk/diagnostics.h>

namespace jaywalk::ast {

struct Plan;
struct Trigger;
struct Formula;

enum class Kind : std::uint8_t {
  number,    // number
  string,    // text: the value, `\n` and `\"` converted, other escapes as written
  variable,  // text: the name (`_` and `_X` included); annots, ns, negated
  literal,   // text: the functor (quoted atoms keep their quotes); args, annots, ns, negated
  truth,     // text: "true" or "false"
  list,      // args: the elements; tail: variable, list or null
  unary,     // op: negative, positive, logical_not; args[0]
  binary,    // op; args[0], args[1]
  body,      // formulas: a plan body as a term, `{ !a; +b }`, perhaps empty
  trigger,   // trigger: an event trigger as a term, `{+!g}`
  plan,      // plan: a plan as a term, `{ @l +!g : c <- b }`
  rule,      // args[0]: the head literal, args[1]: the formula, `{ h :- b }`
};

enum class Operator : std::uint8_t {
  none,
  // unary
  negative,
  positive,
  logical_not,
  // logical
  logical_and,
  logical_or,
  // relational, in this order: < <= > >= == \== = =..
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  unify,
  univ,
  // arithmetic: + - * / div mod **
  add,
  subtract,
  multiply,
  divide,
  int_divide,
  modulo,
  power,
};

struct Node {
  Kind kind = Kind::truth;
  Operator op = Operator::none;
  /// Strong negation `~`, of literals and variables.
  bool negated = false;
  /// The namespace prefix is a bare `::`, that is, the module's own namespace.
  bool this_namespace = false;
  /// Written within parentheses, as `(X + 1)`; the printer of programs keeps them.
  bool parenthesised = false;
  /// Whether a literal is an internal action or a function, `.print`, `math.max`; not a quoted
  /// atom.
  bool dotted = false;
  Span span;
  std::string_view text;
  double number = 0;
  /// The namespace prefix: an atom or a variable, or null.
  const Node* ns = nullptr;
  std::span<const Node* const> args;
  /// The annotations, a list node, or null.
  const Node* annots = nullptr;
  const Node* tail = nullptr;
  std::span<const Formula> formulas;
  const Plan* plan = nullptr;
  const Trigger* trigger = nullptr;
};

/// The operators of body formulas: `!g !!g ?q +b ++b +<b +>b -b --b -+b`, and none for actions,
/// internal actions, relational expressions and variables (the node says which).
enum class BodyOperator : std::uint8_t {
  none,
  achieve,
  achieve_new_focus,
  test,
  add,
  add_new_focus,
  add_begin,
  add_end,
  remove,
  remove_new_focus,
  replace,
};

/// How a formula was written, when not as the literal that Jason makes of it:
/// `if` → `.if_then_else(C,{A}[,{B}])`, `for` → `.foreach(F,{A})`, `while` → `.loop(C,{A})`,
/// `A |&| B` → `.fork(and,{A},{B})`, `A ||| B` → `.fork(or,{A},{B})`; elif nests.
enum class Statement : std::uint8_t {
  formula,
  if_statement,
  for_loop,
  while_loop,
  fork_and,
  fork_or
};

struct Formula {
  BodyOperator op = BodyOperator::none;
  Statement statement = Statement::formula;
  Span span;
  const Node* node = nullptr;
};

enum class TriggerOperator : std::uint8_t { add, remove, goal_state };  // + - ^
enum class TriggerKind : std::uint8_t { belief, achieve, test };        // (none) ! ?

struct Trigger {
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  Span span;
  /// A literal, or a variable (which may carry annotations).
  const Node* literal = nullptr;
};

struct Plan {
  Span span;
  /// The label: a literal, a variable (in plan terms), a list (`@[atomic]`), or null.
  const Node* label = nullptr;
  Trigger trigger;
  const Node* context = nullptr;
  /// The goal condition, `<: F`, of AgentSpeak(ER), or null.
  const Node* goal_condition = nullptr;
  /// There was an arrow, perhaps with nothing behind it.
  bool has_body = false;
  std::span<const Formula> body;
  std::span<const Plan* const> subplans;
};

enum class ComponentKind : std::uint8_t { belief, goal, plan, directive };

/// A part of a program at its outermost level or within `{begin ...} ... {end}`.
struct Component {
  ComponentKind kind = ComponentKind::belief;
  Span span;
  /// belief: the head; goal: the literal; directive: its name and arguments as a literal.
  const Node* literal = nullptr;
  /// belief: the body of a rule, or null.
  const Node* body = nullptr;
  const Plan* plan = nullptr;
  /// directive: it is `{begin ...}`, and `inner` is what stands before its `{end}`.
  bool is_block = false;
  std::span<const Component> inner;
};

/// Owns the nodes of one or more parsed texts.
using Arena = std::pmr::monotonic_buffer_resource;

/// One parsed file.
struct File {
  SourcePtr source;
  std::unique_ptr<Arena> arena;
  std::span<const Component> components;
};

/// `.print`, `my.action`, `math.max`: a literal that is an internal action or a function.
[[nodiscard]] inline bool is_internal(const Node& node) {
  return node.kind == Kind::literal && node.dotted;
}

/// An operation whose value is a number.
[[nodiscard]] bool is_arithmetic(const Node& node);

/// The name of the node in diagnostics: "a number", "an internal action".
[[nodiscard]] std::string_view description_of(const Node& node);

/// How operators are written, with the blanks around them; empty for a formula without one.
[[nodiscard]] std::string_view spelling_of(Operator op);
[[nodiscard]] std::string_view spelling_of(BodyOperator op);
/// The operator and kind, `+!`; `^` stands for changes of goals' states.
[[nodiscard]] std::string_view spelling_of(const Trigger& trigger);

}  // namespace jaywalk::ast
