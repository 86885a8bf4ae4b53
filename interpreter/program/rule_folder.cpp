// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/rule_folder.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "interpreter/logic/machine.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

constexpr std::size_t kDeepest = 8;        // rules within rules
constexpr std::size_t kMostGoals = 1000;   // of a predicate's rules and those within them
constexpr std::size_t kMostAnswers = 256;  // of a predicate
constexpr std::uint64_t kMostInferences = 100'000;

using Known = std::vector<bool>;  // which slots of a rule, or arguments of a query, have a value

bool is_simple(Value value) { return value.is_number() || value.is_atom(); }

bool is_known(Value term, const Known& slots) {
  if (term.is_slot()) return slots[term.slot_index()];
  if (is_form(term, Form::expression)) {
    return std::ranges::all_of(term.structure()->arg_span(),
                               [&](Value arg) { return is_known(arg, slots); });
  }
  return is_simple(term);
}

bool are_slots_or_simple(std::span<const Value> terms) {
  return std::ranges::all_of(terms, [](Value term) { return term.is_slot() || is_simple(term); });
}

std::span<const Value> args_of(Value literal) {
  return literal.is_structure() ? literal.structure()->arg_span() : std::span<const Value>();
}

/// Finds the predicates on which the answers to a predicate's queries depend.
class Dependencies {
 public:
  Dependencies(const Program& program, const ConstantPercepts& constants)
      : program_(program), constants_(constants) {}

  /// Whether each answer to a query with these arguments gives all of them values, and is the same
  /// as long as nothing changes that the query needs.
  bool answer_fully(Predicate predicate, const Known& args) {
    if (entered_.size() == kDeepest || std::ranges::count(entered_, predicate) > 0) return false;
    const SharedRows* const begun = begun_with(predicate);
    const SharedRows* const perceived = constants_.find(predicate);
    if ((begun != nullptr) == (perceived != nullptr)) return false;  // neither, or both
    if (perceived != nullptr) of_percepts_ = true;
    need(predicate, begun != nullptr ? *begun : *perceived);
    if (perceived != nullptr) return true;
    if (begun->rules() == 0) return are_simple_facts(*begun);
    if (begun->rule_table() == nullptr) return false;
    entered_.push_back(predicate);
    const bool full = std::ranges::all_of(
        begun->rule_table()->candidates(),
        [&](const RuleTable::Candidate& each) { return answers_fully(*each.rule, args); });
    entered_.pop_back();
    return full;
  }
  [[nodiscard]] bool are_of_percepts() const { return of_percepts_; }
  [[nodiscard]] std::vector<FoldedRules::Need> needs() && { return std::move(needs_); }

 private:
  // Null, too, where plans hear of it, so that each agent believes it by itself.
  [[nodiscard]] const SharedRows* begun_with(Predicate predicate) const {
    const auto& all = program_.beginnings();
    const auto found = std::ranges::find(all, predicate, &Program::Beginning::predicate);
    return found == all.end() ? nullptr : found->rows.get();
  }
  void need(Predicate predicate, const SharedRows& rows) {
    const auto is_same = [&](const FoldedRules::Need& each) { return each.rows == &rows; };
    if (std::ranges::none_of(needs_, is_same)) needs_.push_back({predicate, &rows});
  }
  static bool are_simple_facts(const SharedRows& rows) {
    return std::ranges::all_of(rows.rows(), [](const Row& row) {
      return std::ranges::all_of(args_of(row.fact), is_simple);
    });
  }

  bool answers_fully(const RuleCode& rule, const Known& args) {
    const std::span<const Value> head = args_of(rule.head);
    if (!are_slots_or_simple(head)) return false;
    Known slots(rule.slot_count);
    for (std::size_t i = 0; i < head.size(); ++i) {
      if (head[i].is_slot() && args[i]) slots[head[i].slot_index()] = true;
    }
    for (const Goal* goal = rule.body.entry; goal != nullptr; goal = goal->next) {
      if (++goals_ > kMostGoals || !leads_on(*goal, slots)) return false;
    }
    return std::ranges::all_of(head, [&](Value arg) { return is_known(arg, slots); });
  }
  // Notes which slots have a value after a goal.
  bool leads_on(const Goal& goal, Known& slots) {
    const std::span<const Value> args = goal.args();
    switch (goal.kind) {
      case Goal::Kind::truth:
        return true;
      case Goal::Kind::compare:
        return is_known(args[0], slots) && is_known(args[1], slots);
      case Goal::Kind::unify:
        if (!are_slots_or_simple(args.first(1)) || !is_known(args[1], slots)) return false;
        break;
      case Goal::Kind::query: {
        if (!are_slots_or_simple(args)) return false;
        Known known;
        for (const Value arg : args) known.push_back(is_known(arg, slots));
        if (!answer_fully(goal.predicate, known)) return false;
        break;
      }
      default:
        return false;
    }
    for (const Value arg : args) {
      if (arg.is_slot()) slots[arg.slot_index()] = true;
    }
    return true;
  }

  const Program& program_;
  const ConstantPercepts& constants_;
  std::vector<Predicate> entered_;
  std::vector<FoldedRules::Need> needs_;
  std::size_t goals_ = 0;
  bool of_percepts_ = false;
};

/// An agent's unchanged initial beliefs.
class UnchangedBeliefs {
 public:
  UnchangedBeliefs(const Program& program, SymbolTable& symbols)
      : beliefs_(heap_, symbols), machine_(heap_, symbols, beliefs_, program.actions()) {
    machine_.set_limits(kMostInferences);
    machine_.set_log([this](std::string_view /*warning*/) { is_usual_ = false; });
  }

  void share(const FoldedRules::Need& need) { (void)beliefs_.share(need.predicate, *need.rows); }

  /// None: there are too many, or not all is as usual.
  std::optional<Answers> ask(Predicate predicate, std::size_t arity) {
    Answers answers{.arity = arity, .values = {}, .inferences = {}};
    const Goal query = query_for(predicate, arity);
    std::vector<Value> slots(arity);
    const std::vector<Symbol> names(arity);
    machine_.unifier().set_slot_names(names);
    is_usual_ = true;
    counted_ = machine_.inferences() + 1;  // with the query's own
    try {
      machine_.solve_all(&query, slots.data(), [&] {
        add(slots, answers);
        return is_usual_;
      });
    } catch (const QueryLimit&) {
      return std::nullopt;
    } catch (const DivisionByZero&) {
      return std::nullopt;
    } catch (const TermTooDeep&) {
      return std::nullopt;
    }
    count_inferences(answers);
    if (!is_usual_) return std::nullopt;
    return answers;
  }

 private:
  Goal query_for(Predicate predicate, std::size_t arity) {
    std::vector<Value> args;
    for (std::uint32_t i = 0; i < arity; ++i) args.push_back(Value::slot(i));
    Goal query;
    query.kind = Goal::Kind::query;
    query.predicate = predicate;
    query.is_plain = true;
    query.term = arity == 0 ? Value::atom(predicate) : heap_.structure(predicate, args);
    query.note_args();
    return query;
  }
  // Adds the inferences since the last answer.
  void count_inferences(Answers& answers) {
    answers.inferences.push_back(machine_.inferences() - counted_);
    counted_ = machine_.inferences();
  }
  void add(std::span<const Value> slots, Answers& answers) {
    count_inferences(answers);
    if (answers.size() == kMostAnswers) is_usual_ = false;
    for (const Value slot : slots) {
      const Value value = deref(slot);
      if (!is_simple(value)) is_usual_ = false;
      answers.values.push_back(value);
    }
  }

  Heap heap_;
  BeliefBase beliefs_;
  Machine machine_;
  std::uint64_t counted_ = 0;  // the machine's inferences at the last answer
  bool is_usual_ = true;
};

}  // namespace

std::vector<std::unique_ptr<const FoldedRules>> fold_rules(const Program& program,
                                                           const ConstantPercepts& constants,
                                                           SymbolTable& symbols) {
  std::vector<std::unique_ptr<const FoldedRules>> folded;
  UnchangedBeliefs beliefs(program, symbols);
  for (const auto& [predicate, table] : program.rule_tables()) {
    const std::size_t arity = symbols.signature(predicate).arity;
    Dependencies dependencies(program, constants);
    if (!dependencies.answer_fully(predicate, Known(arity)) || !dependencies.are_of_percepts()) {
      continue;
    }
    std::vector<FoldedRules::Need> needs = std::move(dependencies).needs();
    for (const FoldedRules::Need& each : needs) beliefs.share(each);
    std::optional<Answers> answers = beliefs.ask(predicate, arity);
    if (!answers) continue;
    folded.push_back(std::make_unique<const FoldedRules>(predicate, table, std::move(needs),
                                                         std::move(*answers)));
  }
  return folded;
}

}  // namespace jaywalk
