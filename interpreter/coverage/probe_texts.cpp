// SPDX-License-Identifier: Apache-2.0
// Finds the places of the probes' subjects in the programs' texts.

#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

#include "interpreter/coverage/source_coverage.h"
#include "interpreter/syntax/parser.h"

namespace jaywalk {
namespace {

// One line, white space as single blanks.
std::string on_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool is_space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!is_space) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

CoveredPlace place_of(const Source& source, Span span) {
  const Source::Position first = source.position(span.begin);
  const Source::Position last = source.position(span.end > span.begin ? span.end - 1 : span.end);
  return {first.line, first.column, last.line, last.column};
}

/// The places of the conditions and formulas of a plan or rule, in the order of the probes.
struct Places {
  Span whole;
  std::vector<Span> conditions;
  std::vector<Span> formulas;
};

void add_conditions(const ast::Node& node, std::vector<Span>& places) {
  using ast::Operator;
  const bool is_logical = node.op == Operator::logical_and || node.op == Operator::logical_or ||
                          node.op == Operator::logical_not;
  if (!is_logical) {
    places.push_back(node.span);
    return;
  }
  for (const ast::Node* const part : node.args) add_conditions(*part, places);
}

void add_formulas(std::span<const ast::Formula> body, std::vector<Span>& places) {
  for (const ast::Formula& formula : body) {
    // A body that stands as a formula is a part of this one.
    if (formula.op == ast::BodyOperator::none && formula.node->kind == ast::Kind::body) {
      add_formulas(formula.node->formulas, places);
      continue;
    }
    places.push_back(formula.span);
    if (formula.statement == ast::Statement::formula) continue;
    for (const ast::Node* const part : formula.node->args) {
      if (part->kind == ast::Kind::body) add_formulas(part->formulas, places);
    }
  }
}

/// The plans and rules of a file by the line where they begin; several on a line in their order.
class WrittenFile {
 public:
  explicit WrittenFile(SourcePtr source) : source_(source) {
    Diagnostics ignored;
    file_ = parse_agent(std::move(source), ignored);
    for (const ast::Component& component : file_.components) add(component);
  }

  [[nodiscard]] const SourcePtr& source() const { return source_; }
  [[nodiscard]] const Places* plan(std::uint32_t line, std::size_t ordinal) const {
    const auto found = plans_.find(line);
    if (found == plans_.end() || ordinal >= found->second.size()) return nullptr;
    return &found->second[ordinal];
  }
  [[nodiscard]] std::string trigger(const Places& places) const {
    return triggers_.at(places.whole.begin);
  }
  /// REQUIRES: a rule's head begins there.
  [[nodiscard]] const Places* rule(std::uint32_t begin) const {
    const auto found = rules_.find(begin);
    return found == rules_.end() ? nullptr : &found->second;
  }

 private:
  void add(const ast::Component& component) {
    if (component.kind == ast::ComponentKind::plan) add(*component.plan);
    if (component.kind == ast::ComponentKind::belief && component.body != nullptr) {
      Places places{.whole = component.span};
      add_conditions(*component.body, places.conditions);
      rules_.emplace(component.literal->span.begin, std::move(places));
    }
    for (const ast::Component& inner : component.inner) add(inner);
  }
  void add(const ast::Plan& plan) {
    Places places{.whole = plan.span};
    if (plan.context != nullptr) add_conditions(*plan.context, places.conditions);
    add_formulas(plan.body, places.formulas);
    triggers_.emplace(plan.span.begin, on_one_line(source_->text(plan.trigger.span)));
    plans_[source_->position(plan.span.begin).line].push_back(std::move(places));
    for (const ast::Plan* const inner : plan.subplans) add(*inner);
  }

  SourcePtr source_;
  ast::File file_;
  std::unordered_map<std::uint32_t, std::vector<Places>> plans_;
  std::unordered_map<std::uint32_t, Places> rules_;
  std::unordered_map<std::uint32_t, std::string> triggers_;
};

class Finder {
 public:
  Finder(const Probes& probes, std::span<const SourcePtr> sources) : probes_(probes) {
    for (const SourcePtr& source : sources) sources_.emplace(source->name(), source);
    texts_.plans.resize(probes.plans().size());
    texts_.rules.resize(probes.rules().size());
    texts_.conditions.resize(probes.conditions().size());
    texts_.formulas.resize(probes.formulas().size());
  }

  ProbeTexts run() {
    std::map<std::pair<std::string, std::uint32_t>, std::size_t> seen;  // plans on a line
    for (std::size_t i = 0; i < probes_.plans().size(); ++i) {
      const ProbedPlan& plan = probes_.plans()[i];
      // Another program has the same plans from the beginning.
      if (plan.first_plan_of_program) seen.clear();
      find_plan(i, seen[{plan.plan->file, plan.plan->line}]++);
    }
    for (std::size_t i = 0; i < probes_.rules().size(); ++i) find_rule(i);
    return std::move(texts_);
  }

 private:
  const WrittenFile* written(const std::string& name) {
    const auto source = sources_.find(name);
    if (source == sources_.end()) return nullptr;
    std::unique_ptr<WrittenFile>& file = files_[name];
    if (file == nullptr) file = std::make_unique<WrittenFile>(source->second);
    return file.get();
  }

  void find_plan(std::size_t index, std::size_t ordinal) {
    const ProbedPlan& plan = probes_.plans()[index];
    const WrittenFile* const file = written(plan.plan->file);
    if (file == nullptr) return;
    const Places* const places = file->plan(plan.plan->line, ordinal);
    if (places == nullptr) return;
    texts_.plans[index] = {file->source(), place_of(*file->source(), places->whole),
                           file->trigger(*places)};
    set(texts_.conditions, plan.first_condition, plan.conditions, *file, places->conditions);
    set(texts_.formulas, plan.first_formula, plan.formulas, *file, places->formulas);
  }

  void find_rule(std::size_t index) {
    const ProbedRule& rule = probes_.rules()[index];
    if (rule.where.source == nullptr) return;
    const WrittenFile* const file = written(rule.where.source->name());
    const Places* const places = file == nullptr ? nullptr : file->rule(rule.where.span.begin);
    if (places == nullptr) return;
    texts_.rules[index] = {file->source(), place_of(*file->source(), places->whole),
                           on_one_line(file->source()->text(rule.where.span))};
    set(texts_.conditions, rule.first_condition, rule.conditions, *file, places->conditions);
  }

  // Patterns of goals (`{begin bdg(g)}`) rewrite plans: those are not as they are written.
  static void set(std::vector<WrittenAs>& texts, std::size_t first, std::size_t count,
                  const WrittenFile& file, const std::vector<Span>& spans) {
    if (spans.size() != count) return;
    const Source& source = *file.source();
    for (std::size_t i = 0; i < count; ++i) {
      texts[first + i] = {file.source(), place_of(source, spans[i]),
                          on_one_line(source.text(spans[i]))};
    }
  }

  const Probes& probes_;
  std::unordered_map<std::string, SourcePtr> sources_;
  std::unordered_map<std::string, std::unique_ptr<WrittenFile>> files_;
  ProbeTexts texts_;
};

}  // namespace

ProbeTexts find_texts(const Probes& probes, std::span<const SourcePtr> sources) {
  return Finder(probes, sources).run();
}

}  // namespace jaywalk
