// SPDX-License-Identifier: Apache-2.0
#pragma once

// Syntax trees to terms: templates with slots for programs, or terms with variables for texts that
// are read at run time. Namespaces are resolved here.

#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "interpreter/logic/action.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

/// The variables of one clause: equal names are one variable, each `_` is another.
class VariableScope {
 public:
  enum class Kind { slots, variables };
  VariableScope(Kind kind, Heap& heap, SymbolTable& symbols)
      : kind_(kind), heap_(heap), symbols_(symbols) {}

  [[nodiscard]] Value variable(std::string_view name);
  /// Unset if there is no such variable yet.
  [[nodiscard]] Value find(std::string_view name) const {
    const auto found = known_.find(std::string(name));
    return found == known_.end() ? Value() : found->second;
  }
  /// The names of all variables, in the order of their first occurrence.
  [[nodiscard]] std::vector<Symbol>& slot_names() { return slot_names_; }

 private:
  Kind kind_;
  Heap& heap_;
  SymbolTable& symbols_;
  std::unordered_map<std::string, Value> known_;
  std::vector<Symbol> slot_names_;
};

class Translator {
 public:
  Translator(Heap& heap, SymbolTable& symbols, const ActionRegistry& actions)
      : heap_(heap), symbols_(symbols), actions_(actions) {}

  /// Terms, such as arguments and elements of lists, are in the default namespace; literals and
  /// formulas are in the one in force.
  [[nodiscard]] Value term(const ast::Node& node, VariableScope& scope);
  /// A literal that is written without annotations gets those given.
  [[nodiscard]] Value literal(const ast::Node& node, VariableScope& scope,
                              Value unless_annotated = Value::empty_list()) {
    return node.kind == ast::Kind::literal ? translate_literal(node, scope, unless_annotated)
                                           : translate(node, scope);
  }
  [[nodiscard]] Value formula(const ast::Node& node, VariableScope& scope) {
    return translate(node, scope);
  }
  /// A plan of a program, whose label is in the namespace in force.
  [[nodiscard]] Value program_plan(const ast::Plan& plan, VariableScope& scope);
  /// A term of form plan; sub-plans, if any, are left to the caller.
  [[nodiscard]] Value plan(const ast::Plan& plan, VariableScope& scope);
  [[nodiscard]] Value trigger(const ast::Trigger& trigger, VariableScope& scope);
  [[nodiscard]] Value body(std::span<const ast::Formula> formulas, VariableScope& scope);

  /// The namespace in force, and what its name stands for (`local` ones are renamed).
  void set_namespace(Symbol ns) { module_ = namespace_ = ns; }
  [[nodiscard]] Symbol current_namespace() const { return module_; }
  void rename_namespace(Symbol written, Symbol meant) { renamed_[written] = meant; }
  /// The generated names of a file's local namespaces, which no other file shares.
  using LocalNamespaces = std::unordered_map<Symbol, Symbol>;
  LocalNamespaces exchange_local(LocalNamespaces local) {
    return std::exchange(renamed_, std::move(local));
  }
  [[nodiscard]] Symbol resolve_namespace(std::string_view written);
  /// Functions of the program itself (`register_function`).
  void add_function(std::string_view name, std::size_t arity);
  /// Lines of steps are counted in this source.
  void set_source(const Source* source) { source_ = source; }

 private:
  Value translate(const ast::Node& node, VariableScope& scope);
  Value translate_literal(const ast::Node& node, VariableScope& scope,
                          Value unless_annotated = Value::empty_list());
  Value translate_variable(const ast::Node& node, VariableScope& scope);
  Value translate_unary(const ast::Node& node, VariableScope& scope);
  Value translate_binary(const ast::Node& node, VariableScope& scope);
  Value translate_list(const ast::Node& node, VariableScope& scope);
  Value operand(const ast::Node& node, VariableScope& scope);
  Value statement(const ast::Formula& formula, VariableScope& scope);
  Value annotations(const ast::Node* annots, VariableScope& scope);
  Value step(const ast::Formula& formula, VariableScope& scope);
  Value label(const ast::Plan& plan, VariableScope& scope);
  Value plan_with_label(Value label, const ast::Plan& plan, VariableScope& scope);
  Predicate predicate_of(const ast::Node& node);
  Symbol namespace_of(const ast::Node& node, std::size_t arity);
  // Whether a name with a dot is that of a function.
  bool is_function(std::string_view name, std::size_t arity) const;

  Heap& heap_;
  SymbolTable& symbols_;
  const ActionRegistry& actions_;
  const Source* source_ = nullptr;
  Symbol module_ = names::default_ns;
  Symbol namespace_ = names::default_ns;  // the module's, but within terms
  std::vector<Value> args_;               // of the literals that are being translated, a stack
  // The latest literal with arguments: many a program has thousands of facts of one predicate.
  Signature last_signature_;
  std::string_view last_functor_;
  Predicate last_predicate_{};
  LocalNamespaces renamed_;
  std::vector<std::pair<std::string, std::size_t>> functions_;
};

}  // namespace jaywalk
