// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/code_text.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

/// Width of the column that names instructions.
constexpr std::size_t kNameWidth = 19;

std::string named(std::string_view name) { return fmt::format("{:<{}}", name, kNameWidth); }

std::string_view name_of(HeadStep::Kind kind) {
  static constexpr std::array kNames{
#define JAYWALK_HEAD_STEP(id, name, meaning) std::string_view(name),
#include "interpreter/logic/code/instructions.def"
  };
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Goal::Kind kind) {
  static constexpr std::array kNames{
#define JAYWALK_GOAL(id, name, meaning) std::string_view(name),
#include "interpreter/logic/code/instructions.def"
  };
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Step::Kind kind) {
  static constexpr std::array kNames{
#define JAYWALK_BODY_STEP(id, name, meaning) std::string_view(name),
#include "interpreter/logic/code/instructions.def"
  };
  return kNames[static_cast<std::size_t>(kind)];
}

// Whether nothing of it is left to the unifier.
bool is_decoded(const Goal& goal) {
  if (goal.kind == Goal::Kind::query) return goal.is_plain;
  return goal.left.kind != Operand::Kind::other && goal.right.kind != Operand::Kind::other;
}

// The code of one plan or rule. Its instructions have numbers in the order of the lines, so that a
// jump can say where it goes.
class CodeWriter {
 public:
  CodeWriter(Heap& heap, SymbolTable& symbols, std::span<const Symbol> names)
      : unifier_(heap, symbols), symbols_(symbols) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      names_.push_back(symbols.symbol(fmt::format("{}@{}", symbols.text(names[i]), i)));
    }
    unifier_.set_slot_names(names_);
  }

  void add_formula(std::string_view title, const Goal* entry) {
    const std::size_t first = lines_.size();
    collect(entry);
    if (lines_.size() > first) lines_[first].title = title;
  }

  void add_body(std::string_view title, const Body& body) {
    const std::size_t first = lines_.size();
    collect(body, 0);
    if (lines_.size() == first) return add_note(title, "empty");
    lines_[first].title = title;
  }

  void add_note(std::string_view title, std::string text) {
    lines_.push_back({.title = title, .text = std::move(text)});
  }

  [[nodiscard]] std::string text() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].goal != nullptr) lines_[i].text = text_of(*lines_[i].goal, i);
      if (lines_[i].step != nullptr) lines_[i].text = text_of(*lines_[i].step, i);
    }
    std::string out;
    for (const Line& line : lines_) {
      const bool is_code = line.goal != nullptr || line.step != nullptr;
      const std::string number = is_code ? std::to_string(number_of(&line - lines_.data())) : "";
      out +=
          fmt::format("  {:<8}{:>3}  {:{}}{}", line.title, number, "", line.depth * 2, line.text);
      if (line.step != nullptr && line.step->place.line > 0) {
        out += fmt::format("   % line {}", line.step->place.line);
      }
      out += '\n';
    }
    return out;
  }

  [[nodiscard]] std::string text_of(Value term) {
    ScratchSlots slots(unifier_, names_.size());
    return source_text(unifier_.instantiate(term, slots.data()), symbols_);
  }

 private:
  struct Line {
    std::string_view title;
    const Goal* goal = nullptr;
    const Step* step = nullptr;
    std::size_t depth = 0;
    std::string text;
  };

  // The number of the instruction on a line.
  [[nodiscard]] std::size_t number_of(std::ptrdiff_t line) const {
    const auto index = static_cast<std::size_t>(line);
    const void* const code = lines_[index].goal != nullptr
                                 ? static_cast<const void*>(lines_[index].goal)
                                 : static_cast<const void*>(lines_[index].step);
    return numbers_.at(code);
  }

  bool add(const void* code, const Line& line) {
    const bool is_new = numbers_.emplace(code, numbers_.size() + 1).second;
    if (is_new) lines_.push_back(line);
    return is_new;
  }

  // Up to `end`, which belongs to what is around.
  void collect(const Goal* goal, std::size_t depth = 0, const Goal* end = nullptr) {
    for (; goal != end && goal != nullptr && add(goal, {.goal = goal, .depth = depth});
         goal = goal->next) {
      const bool is_unfolded = goal->kind == Goal::Kind::unfolded;
      const bool is_within = is_unfolded || goal->kind == Goal::Kind::negation;
      collect(goal->inner, is_within ? depth + 1 : depth, is_unfolded ? goal->next : end);
      collect(goal->other, depth, end);
      for (const Goal* const asked : goal->queries) collect(asked, depth + 1);
    }
  }

  void collect(const Body& body, std::size_t depth) {
    for (const Step& step : body.steps) {
      if (!add(&step, {.step = &step, .depth = depth})) continue;
      if (step.kind == Step::Kind::internal_action && step.goal != nullptr) {
        for (const Goal* const asked : step.goal->queries) collect(asked, depth + 1);
      } else {
        collect(step.goal, depth + 1);
      }
      for (const Goal* const conjunct : step.conjuncts) collect(conjunct, depth + 1);
      for (const Body* const inner : {step.first, step.second}) {
        if (inner != nullptr) collect(*inner, depth + 1);
      }
      for (const Body* const branch : step.branches) collect(*branch, depth + 1);
    }
  }

  [[nodiscard]] std::string jump_to(const void* code) const {
    const auto found = numbers_.find(code);
    return found == numbers_.end() ? "end" : std::to_string(found->second);
  }

  // The line where it continues, unless that is the next line of its kind.
  [[nodiscard]] std::string text_of(const Goal& goal, std::size_t line) {
    std::string text = named(name_of(goal.kind));
    if (goal.kind == Goal::Kind::negation_done)
      return text + "-> " + jump_to(goal.origin) + " fails";
    if (goal.kind == Goal::Kind::negation) {
      return text + (goal.next == nullptr ? "-> done" : "-> " + jump_to(goal.next));
    }
    if (goal.kind == Goal::Kind::disjunction) {
      return fmt::format("{}-> {} or {}", text, jump_to(goal.inner), jump_to(goal.other));
    }
    text += text_of(goal.term);
    const bool may_be = goal.kind == Goal::Kind::query || goal.kind == Goal::Kind::compare ||
                        goal.kind == Goal::Kind::unify;
    if (may_be && is_decoded(goal)) text += "   [decoded]";
    if (goal.action == nullptr && goal.kind == Goal::Kind::action) text += "   [unknown]";
    const bool is_next = line + 1 < lines_.size() && lines_[line + 1].goal == goal.next;
    if (goal.next != nullptr && !is_next) text += "   -> " + jump_to(goal.next);
    return text;
  }

  [[nodiscard]] std::string text_of(const Step& step, std::size_t line) {
    const bool is_statement = step.first != nullptr || !step.branches.empty();
    std::string text = named(name_of(step.kind));
    if (!is_statement && step.kind != Step::Kind::join) text += text_of(step.term);
    if (step.event != nullptr) {
      if (step.event->is_decoded) text += "   [decoded]";
      if (step.event->last_call == EventCode::LastCall::yes) text += "   [last call]";
    }
    for (const Body* const inner : {step.first, step.second}) {
      if (inner != nullptr && !inner->steps.empty()) {
        text += fmt::format("{} {}", inner == step.first ? "-> then" : " else",
                            jump_to(&inner->steps.front()));
      }
    }
    for (const Body* const branch : step.branches) {
      if (!branch->steps.empty()) text += fmt::format("-> {} ", jump_to(&branch->steps.front()));
    }
    std::size_t next = line + 1;
    while (next < lines_.size() && lines_[next].step == nullptr) ++next;
    const Step* const follower = next < lines_.size() ? lines_[next].step : nullptr;
    if (step.next == nullptr || step.next != follower) text += "   -> " + jump_to(step.next);
    return text;
  }

  Unifier unifier_;
  SymbolTable& symbols_;
  std::vector<Symbol> names_;
  std::vector<Line> lines_;
  std::unordered_map<const void*, std::size_t> numbers_;
};

std::string slots_text(std::span<const Symbol> names, const SymbolTable& symbols) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("{}{}@{}", i == 0 ? "" : " ", symbols.text(names[i]), i);
  }
  return names.empty() ? "none" : text;
}

// The line of the source that something begins in.
std::string source_line(const Program& program, const std::string& file, std::uint32_t line) {
  const SourcePtr source = program.find_source(file);
  if (source == nullptr || line == 0) return {};
  return fmt::format("{}:{}: {}\n", file, line, source->line(line));
}

void add_head(CodeWriter& writer, const HeadCode& code) {
  std::string_view title = "head";
  for (const HeadStep& step : code.steps()) {
    const bool has_slot = step.kind == HeadStep::Kind::first || step.kind == HeadStep::Kind::again;
    const Value shown = has_slot ? Value::slot(step.slot) : step.term;
    writer.add_note(title,
                    named(name_of(step.kind)) + (shown.is_unset() ? "" : writer.text_of(shown)));
    title = "";
  }
}

std::string rule_text(const RuleCode& rule, Heap& heap, SymbolTable& symbols) {
  CodeWriter writer(heap, symbols, rule.slot_names);
  writer.add_note("slots", slots_text(rule.slot_names, symbols));
  add_head(writer, rule.head_code);
  writer.add_formula("body", rule.body.entry);
  return writer.text();
}

std::string plan_text(const Program& program, const Plan& plan, Heap& heap, SymbolTable& symbols) {
  CodeWriter writer(heap, symbols, plan.slot_names);
  const auto& rivals = program.library().candidates(plan.key);
  const auto place = std::find(rivals.begin(), rivals.end(), &plan) - rivals.begin();
  writer.add_note("for",
                  fmt::format("{}{}, plan {} of {}", trigger_operator(plan.key.op, plan.key.kind),
                              writer.text_of(plan.trigger), place + 1, rivals.size()));
  writer.add_note("slots", slots_text(plan.slot_names, symbols));
  if (plan.head.is_decoded) {
    add_head(writer, plan.head.code);
  } else {
    writer.add_note("head", named("get_term") + writer.text_of(plan.trigger));
  }
  writer.add_formula("context", plan.context);
  writer.add_formula("until", plan.goal_condition);
  writer.add_body("body", *plan.code.entry);
  std::string text = source_line(program, plan.file, plan.line) + writer.text();
  if (plan.subplans == nullptr) return text;
  for (const auto& inner : plan.subplans->plans()) {
    text += plan_text(program, *inner, heap, symbols);
  }
  return text;
}

}  // namespace

std::string code_text(const Program& program, SymbolTable& symbols) {
  Heap heap;
  std::string text;
  for (const Program::Belief& belief : program.beliefs()) {
    if (belief.rule == nullptr) continue;
    if (const SourcePtr& source = belief.where.source; source != nullptr) {
      const std::uint32_t line = source->position(belief.where.span.begin).line;
      text += fmt::format("{}:{}: {}\n", source->name(), line, source->line(line));
    }
    text += rule_text(*belief.rule, heap, symbols);
  }
  for (const auto& plan : program.library().plans()) {
    if (!plan->is_standard) text += plan_text(program, *plan, heap, symbols);
  }
  return text;
}

}  // namespace jaywalk
