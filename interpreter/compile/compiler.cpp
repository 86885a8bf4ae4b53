// SPDX-License-Identifier: Apache-2.0
#include "interpreter/compile/compiler.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_map>

#include <fmt/format.h>

#include "interpreter/compile/beginnings.h"
#include "interpreter/compile/goal_patterns.h"
#include "interpreter/compile/kqml_plans.h"
#include "interpreter/compile/translator.h"
#include "interpreter/logic/formula_compiler.h"
#include "interpreter/logic/machine.h"
#include "interpreter/logic/rule_unfolder.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/width.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

/// Fills a program from a source tree, in one pass in source order.
class ProgramBuilder {
 public:
  ProgramBuilder(Program& program, SymbolTable& symbols, const ActionRegistry& actions,
                 Diagnostics& diagnostics, const CompileOptions& options)
      : program_(program),
        symbols_(symbols),
        actions_(actions),
        diagnostics_(diagnostics),
        fresh_names_(options.fresh_names),
        translator_(program.constants_, symbols, actions),
        beliefs_(program.constants_, symbols),
        machine_(program.constants_, symbols, beliefs_, actions) {
    program_.actions_ = &actions;
    if (!options.ns.empty()) translator_.set_namespace(symbols.symbol(options.ns));
  }

  void build(const SourceTree& tree) {
    tree_ = &tree;
    // Functions first: a term that calls one may stand before its registration.
    for (const auto& file : tree.files) {
      program_.sources_.push_back(file->source);
      for (const ast::Component& component : file->components) register_functions(component);
    }
    add_file(tree.main());
    add_default_plans();
    for (const auto& plan : plans_) link(*plan, program_.library_);
    add_rule_tables();
    for (const auto& plan : plans_) unfold_context(*plan);
    program_.beginnings_ = beginnings_of(program_, constants(), symbols_);
  }

 private:
  Heap& constants() { return program_.constants_; }

  SourceSpan where(Span span) const { return {file_->source, span}; }

  void add_file(const ast::File& file) {
    const ast::File* const outer = file_;
    file_ = &file;
    translator_.set_source(file.source.get());
    for (const ast::Component& component : file.components) add_component(component);
    file_ = outer;
    translator_.set_source(outer == nullptr ? nullptr : outer->source.get());
  }

  void add_component(const ast::Component& component) {
    switch (component.kind) {
      case ast::ComponentKind::belief:
        add_belief(component);
        return;
      case ast::ComponentKind::goal:
        add_goal(component);
        return;
      case ast::ComponentKind::plan:
        add_plan(*component.plan, program_.library_, nullptr);
        return;
      case ast::ComponentKind::directive:
        add_directive(component);
        return;
    }
  }

  static std::string file_name(const ast::File* file) {
    return file == nullptr ? std::string() : file->source->name();
  }

  // False, with an error, if a clause has more variables than there are numbers.
  bool has_few_variables(VariableScope& scope, Span clause) {
    if (scope.slot_names().size() <= kMostParts) return true;
    diagnostics_.error(where({clause.begin, clause.begin}),
                       fmt::format("more than {} variables", kMostParts),
                       "split it into several rules or plans");
    return false;
  }

  // An initial belief or goal: its source is the agent itself if none is written.
  Value own_literal(const ast::Node& node, VariableScope& scope) {
    const Value literal = translator_.literal(node, scope, source_self());
    if (!is_literal(literal) || has_source(literal_parts(literal).annots)) return literal;
    const Value annots =
        union_of(constants(), literal_parts(literal).annots, source_self(), symbols_);
    return with_annotations(constants(), literal, annots);
  }

  void add_belief(const ast::Component& component) {
    VariableScope scope(VariableScope::Kind::slots, constants(), symbols_);
    Value head = own_literal(*component.literal, scope);
    if (!is_literal(head)) {
      diagnostics_.error(where(component.literal->span), "a belief must be a literal");
      return;
    }
    const Predicate predicate = literal_parts(head).predicate;
    const SourceSpan place = where(component.literal->span);
    if (component.body == nullptr && scope.slot_names().empty()) {
      // Arithmetic in facts is evaluated now.
      try {
        head = machine_.unifier().apply(head);
      } catch (const DivisionByZero&) {
        diagnostics_.error(place, "division by zero in a belief");
        return;
      }
      program_.beliefs_.push_back({head, nullptr, predicate, place});
      return;
    }
    const Value body = component.body == nullptr ? Value::atom(predicates::truth)
                                                 : translator_.formula(*component.body, scope);
    if (!has_few_variables(scope, component.span)) return;
    program_.rules_.push_back(
        make_rule(head, body, std::move(scope.slot_names()), constants(), actions_, symbols_));
    program_.beliefs_.push_back({Value(), program_.rules_.back().get(), predicate, place});
  }

  void add_rule_tables() {
    std::unordered_map<Predicate, std::vector<RuleTable::Candidate>> candidates;
    std::vector<Predicate> order;
    for (const Program::Belief& belief : program_.beliefs_) {
      if (belief.rule == nullptr) continue;
      const Structure* const head =
          belief.rule->head.is_structure() ? belief.rule->head.structure() : nullptr;
      const std::uint32_t key =
          head == nullptr || head->arity == 0 ? 0 : argument_key(head->arg(0));
      auto& its = candidates[belief.predicate];
      if (its.empty()) order.push_back(belief.predicate);
      its.push_back({key, belief.rule->head_code.has_tests(), belief.rule});
    }
    for (const Predicate predicate : order) {
      auto& its = candidates[predicate];
      if (its.size() > RuleTable::kMostRules) continue;
      program_.rule_tables_.emplace_back(predicate, RuleTable(std::move(its)));
    }
  }

  // The rules that its context asks are asked in its own frame.
  void unfold_context(Plan& plan) {
    if (plan.context == nullptr || plan.is_standard || plan.subplans != nullptr) return;
    RuleUnfolder unfolder(program_.rule_tables_, constants(), symbols_, plan.slot_names);
    FormulaCompiler compiler(plan.code.formulas, actions_, symbols_);
    compiler.unfold_with(unfolder);
    const Goal* const unfolded = compiler.compile(plan_parts(plan.source).context, nullptr);
    if (!unfolder.has_unfolded()) return;
    plan.context = unfolded;
    plan.slot_count = static_cast<std::uint32_t>(plan.slot_names.size());
  }

  void add_goal(const ast::Component& component) {
    VariableScope scope(VariableScope::Kind::slots, constants(), symbols_);
    const Value literal = own_literal(*component.literal, scope);
    if (!is_literal(literal)) {
      diagnostics_.error(where(component.literal->span), "an initial goal must be a literal",
                         component.literal->kind == ast::Kind::variable
                             ? "names begin with a lower-case letter"
                             : "");
      return;
    }
    if (!has_few_variables(scope, component.span)) return;
    const auto count = static_cast<std::uint32_t>(scope.slot_names().size());
    program_.goals_.push_back({literal, count, std::move(scope.slot_names())});
  }

  void add_plan(const ast::Plan& plan, PlanLibrary& library, const Plan* enclosing) {
    VariableScope scope(VariableScope::Kind::slots, constants(), symbols_);
    const Value term = translator_.program_plan(plan, scope);
    if (!has_few_variables(scope, plan.span)) return;
    const auto compiled = compile_plan(term, scope.slot_names(), actions_, symbols_);
    if (compiled == nullptr) {
      diagnostics_.error(where(plan.span), "this is not a plan");
      return;
    }
    compiled->is_standard = in_standard_plans_;
    if (!in_standard_plans_ && !label_is_free(compiled, plan, library)) return;
    compiled->file = file_name(file_);
    compiled->line = file_ == nullptr ? 0 : file_->source->position(plan.span.begin).line;
    if (enclosing != nullptr) inherit_variables(*compiled, *enclosing);
    if (!plan.subplans.empty()) {
      compiled->subplans = std::make_unique<PlanLibrary>();
      compiled->is_simple = false;
      for (const ast::Plan* inner : plan.subplans) {
        add_plan(*inner, *compiled->subplans, compiled.get());
      }
    }
    complete_label(*compiled, enclosing == nullptr);
    library.add(compiled);
    if (enclosing == nullptr) plans_.push_back(compiled);
  }

  // A sub-plan sees the enclosing plan's variables by name, and hands them on to its own sub-plans:
  // it has a slot for each of them.
  static void inherit_variables(Plan& plan, const Plan& enclosing) {
    for (std::uint32_t outer = 0; outer < enclosing.slot_names.size(); ++outer) {
      const Symbol name = enclosing.slot_names[outer];
      if (name == names::unnamed) continue;
      const auto known = std::find(plan.slot_names.begin(), plan.slot_names.end(), name);
      const auto own = static_cast<std::uint32_t>(known - plan.slot_names.begin());
      if (known == plan.slot_names.end()) plan.slot_names.push_back(name);
      plan.inherited.emplace_back(own, outer);
    }
    plan.slot_count = static_cast<std::uint32_t>(plan.slot_names.size());
    plan.own_slots = plan.slot_count;
    std::vector<std::uint32_t> inherits;
    for (const auto& [own, outer] : plan.inherited) inherits.push_back(own);
    plan.head = decode_head(plan.trigger, plan.slot_names, inherits);
  }

  // Plans without a label get one. All have a source, which .remove_plan asks for, and those of the
  // program itself their file.
  void complete_label(Plan& plan, bool is_outermost) {
    Value annots = is_literal(plan.label) ? literal_parts(plan.label).annots : Value::empty_list();
    annots = union_of(constants(), annots, source_self(), symbols_);
    if (is_outermost && !plan.is_standard) {
      const Value file = constants().text("file:" + plan.file);
      const Value url = constants().structure(symbols_.predicate("url", 1), std::span(&file, 1));
      annots = union_of(constants(), annots, constants().pair(url, Value::empty_list()), symbols_);
    }
    const bool named =
        is_literal(plan.label) && !symbols_.functor(literal_parts(plan.label).predicate).empty();
    if (!named) plan.label = Value::atom(symbols_.predicate(new_name("p__", labelled_), 0));
    plan.label = with_annotations(constants(), plan.label, annots);
  }

  std::string new_name(std::string_view before, int& count, std::string_view after = {}) {
    std::string name;
    do {
      name = fmt::format("{}{}{}", before, ++count, after);
    } while (fresh_names_ && symbols_.knows(name));
    return name;
  }

  // A label is one plan's in its library. An equal plan of that label (a file that two others
  // include) is the one that is there already; a different one is a mistake.
  bool label_is_free(const std::shared_ptr<Plan>& plan, const ast::Plan& written,
                     const PlanLibrary& library) {
    if (!is_literal(plan->label) || written.label == nullptr ||
        written.label->kind != ast::Kind::literal || !written.label->args.empty()) {
      return true;
    }
    const std::string label =
        term_text(with_annotations(constants(), plan->label, Value::empty_list()), symbols_);
    const auto [known, is_new] = labels_[&library].emplace(label, plan);
    if (is_new) return true;
    if (!equal_plans(*known->second, *plan)) {
      diagnostics_.error(where(written.label->span),
                         fmt::format("another plan has the label '{}' already", label),
                         "give each plan a label of its own, or none");
    }
    return false;
  }

  void register_functions(const ast::Component& component) {
    for (const ast::Component& inner : component.inner) register_functions(inner);
    if (component.kind != ast::ComponentKind::directive) return;
    const ast::Node& directive = *component.literal;
    if (directive.text != "register_function") return;
    if (directive.args.size() != 3 || directive.args[0]->kind != ast::Kind::string ||
        directive.args[1]->kind != ast::Kind::number ||
        directive.args[2]->kind != ast::Kind::string) {
      return;
    }
    const auto arity =
        static_cast<std::uint16_t>(std::clamp(directive.args[1]->number, 0.0, 255.0));
    translator_.add_function(directive.args[0]->text, arity);
    program_.functions_.push_back(
        {symbols_.symbol(directive.args[0]->text), arity,
         symbols_.predicate(directive.args[2]->text, static_cast<std::uint16_t>(arity + 1))});
  }

  [[nodiscard]] bool is_known_function(std::string_view name) const {
    return std::ranges::any_of(actions_.functions(),
                               [&](const auto& function) { return function.name == name; });
  }

  void add_directive(const ast::Component& component) {
    const ast::Node& directive = *component.literal;
    if (directive.text == "include") {
      add_include(component);
    } else if (directive.text == "namespace") {
      add_namespace(component);
    } else if (directive.text == "register_function") {
      if (directive.args.size() == 1 && !is_known_function(directive.args[0]->text)) {
        diagnostics_.error(
            where(directive.span),
            fmt::format("the function '{}' is a Java class", directive.args[0]->text),
            "run with --jason PATH (see docs/guides/from_jason.md), or define it by "
            "a rule: register_function(\"my.f\", Arity, \"pred\")");
      }
    } else if (is_goal_pattern(directive.text)) {
      add_pattern(component);
    } else {
      diagnostics_.error(where(directive.span),
                         fmt::format("there is no directive '{}'", directive.text),
                         did_you_mean(directive.text, directive_names()));
    }
  }

  void add_include(const ast::Component& component) {
    const auto found = tree_->includes.find(&component);
    if (found == tree_->includes.end()) return;  // has been reported
    const ast::Node& directive = *component.literal;
    const Symbol outer = translator_.current_namespace();
    if (directive.args.size() > 1) {
      const ast::Node& ns = *directive.args[1];
      translator_.set_namespace(ns.kind == ast::Kind::variable
                                    ? own_namespace("ns", anonymous_namespaces_)
                                    : translator_.resolve_namespace(ns.text));
    }
    Translator::LocalNamespaces local = translator_.exchange_local({});
    add_file(*found->second);
    translator_.exchange_local(std::move(local));
    translator_.set_namespace(outer);
  }

  void add_namespace(const ast::Component& component) {
    const ast::Node& directive = *component.literal;
    if (directive.args.empty() || directive.args[0]->kind != ast::Kind::literal) {
      diagnostics_.error(where(directive.span), "expected a name, as in namespace(n)");
      return;
    }
    const Symbol written = symbols_.symbol(directive.args[0]->text);
    if (directive.args.size() > 1 && directive.args[1]->text == "local") {
      // A second directive goes on with the file's local namespace.
      if (translator_.resolve_namespace(directive.args[0]->text) == written) {
        translator_.rename_namespace(
            written, own_namespace(std::string_view(&kLocalNamespace, 1), local_namespaces_,
                                   directive.args[0]->text));
      }
    } else if (directive.args.size() > 1 && directive.args[1]->text == "global") {
      translator_.rename_namespace(written, written);
    }
    const Symbol outer = translator_.current_namespace();
    translator_.set_namespace(translator_.resolve_namespace(directive.args[0]->text));
    for (const ast::Component& inner : component.inner) add_component(inner);
    translator_.set_namespace(outer);
  }

  Symbol own_namespace(std::string_view before, int& count, std::string_view after = {}) {
    program_.has_own_namespaces_ = true;
    return symbols_.symbol(new_name(before, count, after));
  }

  void add_pattern(const ast::Component& component) {
    std::string problem;
    const std::string text = expand_goal_pattern(component, *file_->source, problem);
    if (!problem.empty()) {
      diagnostics_.error(where(component.literal->span), problem);
      return;
    }
    auto source = std::make_shared<const Source>(file_->source->name(), text);
    expanded_.push_back(std::make_unique<ast::File>(parse_agent(source, diagnostics_)));
    add_file(*expanded_.back());
  }

  void add_default_plans() {
    auto source = std::make_shared<const Source>("kqmlPlans.asl", std::string(kKqmlPlans));
    expanded_.push_back(std::make_unique<ast::File>(parse_agent(source, diagnostics_)));
    translator_.set_namespace(names::default_ns);
    translator_.exchange_local({});
    in_standard_plans_ = true;
    add_file(*expanded_.back());
    in_standard_plans_ = false;
  }

  Program& program_;
  SymbolTable& symbols_;
  const ActionRegistry& actions_;
  Diagnostics& diagnostics_;
  bool fresh_names_;
  Translator translator_;
  BeliefBase beliefs_;  // empty: to evaluate arithmetic in facts
  Machine machine_;
  const SourceTree* tree_ = nullptr;
  const ast::File* file_ = nullptr;
  // Each library's plans whose label was written, by its text.
  std::unordered_map<const PlanLibrary*,
                     std::unordered_map<std::string, std::shared_ptr<const Plan>>>
      labels_;
  std::vector<std::unique_ptr<ast::File>> expanded_;
  std::vector<std::shared_ptr<Plan>> plans_;
  bool in_standard_plans_ = false;
  int labelled_ = 0;
  int anonymous_namespaces_ = 0;
  int local_namespaces_ = 0;
};

std::shared_ptr<const Program> compile(const SourceTree& tree, SymbolTable& symbols,
                                       Diagnostics& diagnostics, const CompileOptions& options) {
  const std::size_t errors_before = diagnostics.error_count();
  if (errors_before > tree.left_out_errors) return nullptr;
  const std::string file = tree.main().source->name();
  auto program = std::make_shared<Program>(std::filesystem::path(file).stem().string());
  const ActionRegistry& actions =
      options.actions == nullptr ? standard_actions() : *options.actions;
  ProgramBuilder(*program, symbols, actions, diagnostics, options).build(tree);
  if (diagnostics.error_count() > errors_before) return nullptr;
  return program;
}

std::vector<std::string> parameter_names(const Program& program, const SymbolTable& symbols) {
  std::vector<std::string> found;
  for (const Program::Belief& belief : program.beliefs()) {
    if (belief.rule != nullptr) continue;
    const Signature& signature = symbols.signature(belief.predicate);
    if (signature.arity == 0 || signature.ns != names::default_ns) continue;
    std::string name = fmt::format("{}{}/{}", signature.negated ? "~" : "",
                                   symbols.text(signature.functor), signature.arity);
    if (std::find(found.begin(), found.end(), name) == found.end()) {
      found.push_back(std::move(name));
    }
  }
  return found;
}

}  // namespace jaywalk
