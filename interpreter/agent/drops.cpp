// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/drops.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_stack.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/support/text.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMostCauses = 32;  // of one agent; further ones are counted with the last
constexpr std::size_t kLongestText = 300;
// How many goals of a deep stack are named, from its bottom and from its top.
constexpr std::size_t kOuterGoals = 3;
constexpr std::size_t kInnerGoals = 5;

std::string cut(std::string_view text) { return shortened(text, kLongestText); }

std::string goal_with_place(const Intention& intention, const IntendedMeans& means,
                            const SymbolTable& symbols) {
  const std::uint32_t line = means.is_finished() ? means.plan->line : means.step().place.line;
  std::string text = goal_text(intention, means, symbols, kLongestText);
  return line == 0 ? text : fmt::format("{} ({}:{})", text, means.plan->file, line);
}

// The place of the failed formula; none if it was made at run time.
StepPlace place_of(const Intention* intention) {
  if (intention == nullptr || intention->is_finished() || intention->top().is_finished()) {
    return {};
  }
  return intention->top().step().place;
}

// REQUIRES: the place is one of this source, and its column is known.
Span span_of(const Source& source, StepPlace place) {
  const std::uint32_t begin = offset_of(source, {place.line, place.column});
  return {begin, begin + place.length};
}

}  // namespace

std::string literal_text(Predicate predicate, std::span<const Value> args,
                         const SymbolTable& symbols, std::size_t most) {
  std::string text = term_text(Value::atom(predicate), symbols);
  for (std::size_t i = 0; i < args.size() && text.size() <= most; ++i) {
    text += i == 0 ? '(' : ',';
    text += brief_text(args[i], symbols, most);
  }
  if (!args.empty()) text += ')';
  return shortened(text, most);
}

std::string plain_text(Value term, const SymbolTable& symbols, std::size_t most) {
  term = deref(term);
  if (!is_literal(term)) return brief_text(term, symbols, most);
  const LiteralParts parts = literal_parts(term);
  return literal_text(parts.predicate, parts.args, symbols, most);
}

std::string goal_stack_text(const Intention& intention, const SymbolTable& symbols) {
  std::string text;
  const std::size_t size = intention.stack.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (!text.empty()) text += " > ";
    if (i == kOuterGoals && size > kOuterGoals + kInnerGoals + 1) {
      const std::size_t left_out = size - kOuterGoals - kInnerGoals;
      text += fmt::format("... {} more ... > ", left_out);
      i += left_out;
    }
    text += goal_with_place(intention, intention.stack[i], symbols);
  }
  return text;
}

std::string formula_place(const Intention& intention) {
  const StepPlace place = place_of(&intention);
  if (place.line == 0) return {};
  std::string text = fmt::format("{}:{}", intention.top().plan->file, place.line);
  return place.column == 0 ? text : fmt::format("{}:{}", text, place.column);
}

std::string goal_text(const Intention& intention, const IntendedMeans& means,
                      const SymbolTable& symbols, std::size_t most) {
  std::string text;
  if (means.op == TriggerOperator::remove) text += '-';
  if (means.op == TriggerOperator::goal_state) text += '^';
  if (means.op == TriggerOperator::add && means.kind == TriggerKind::belief) text += '+';
  if (!means.trigger.is_unset()) return text + plain_text(means.trigger, symbols, most);
  Heap lists;
  return text + literal_text(means.plan->head.predicate, intention.goal_arguments(means, lists),
                             symbols, most);
}

void show_with_values(Agent& agent, const Intention& intention, Value term,
                      const std::function<void(Value)>& show) {
  const IntendedMeans& top = intention.top();
  Unifier& unifier = agent.machine().unifier();
  const std::span<const Symbol> names = unifier.slot_names();
  const JavaRandom random = agent.random();
  unifier.set_slot_names(top.plan->slot_names);
  ScratchSlots slots(unifier, top.plan->slot_count);
  std::copy_n(intention.values.data() + top.frame, top.plan->slot_count, slots.data());
  try {
    show(deref(unifier.instantiate(term, slots.data())));
  } catch (const DivisionByZero&) {
  } catch (const TermTooDeep&) {
  } catch (const TermTooWide&) {
  } catch (const HeapExhausted&) {
  } catch (const QueryLimit&) {
  }
  unifier.set_slot_names(names);
  agent.random() = random;
}

std::string formula_with_values(Agent& agent, const Intention& intention, const Step& step) {
  std::string text;
  if (step.source.is_unset()) return text;
  show_with_values(agent, intention, step.source,
                   [&](Value formula) { text = term_text(formula, agent.symbols()); });
  return text.empty() ? term_text(step.source, agent.symbols()) : text;
}

std::string describe(const DropCause& cause) {
  std::string text = cause.error;
  if (cause.line > 0) text += fmt::format(", {}:{}", cause.file, cause.line);
  if (cause.line > 0 && cause.column > 0) text += fmt::format(":{}", cause.column);
  if (!cause.formula.empty()) text += ", " + cause.formula;
  if (!cause.message.empty()) text += ": " + cause.message;
  return text;
}

const DropCause& Agent::note_drop(const Intention* intention, const ActionError& error,
                                  Value code) {
  const StepPlace place = place_of(intention);
  const bool nowhere = place.line == 0;
  std::string formula;
  if (nowhere && !code.is_unset()) formula = plain_text(code, symbols_, kLongestText);
  const auto is_same = [&](const DropCause& cause) {
    return cause.line == place.line && cause.column == place.column && cause.error == error.id &&
           (nowhere ? cause.formula == formula : cause.file == intention->top().plan->file);
  };
  std::vector<DropCause>& causes = drops_.all();
  auto cause = std::find_if(causes.begin(), causes.end(), is_same);
  if (cause == causes.end() && causes.size() == kMostCauses) cause = std::prev(causes.end());
  if (cause == causes.end()) {
    cause = causes.insert(causes.end(), DropCause{});
    cause->error = error.id;
    cause->message = cut(error.message);
    cause->formula =
        nowhere || code.is_unset() ? std::move(formula) : plain_text(code, symbols_, kLongestText);
    if (intention != nullptr) cause->goals = goal_stack_text(*intention, symbols_);
    cause->line = place.line;
    cause->column = place.column;
    if (place.line > 0) cause->file = intention->top().plan->file;
  }
  ++cause->times;
  return *cause;
}

// The line of the program that an intention had come to, and its goals: for the first of many equal
// drops.
std::string Agent::drop_details(const Intention& intention, const DropCause& cause) const {
  if (cause.times > 1) return {};
  std::string text;
  const StepPlace place = place_of(&intention);
  const SourcePtr source = place.line == 0 ? nullptr : find_source(cause.file);
  if (source != nullptr && place.column > 0)
    text = "\n" + excerpt({source, span_of(*source, place)});
  if (text.ends_with('\n')) text.pop_back();
  if (!cause.goals.empty()) text += "\n  goals: " + cause.goals;
  return text;
}

SourcePtr Agent::find_source(const std::string& file) const {
  if (SourcePtr source = program_->find_source(file)) return source;
  for (const auto& program : included()) {
    if (SourcePtr source = program->find_source(file)) return source;
  }
  return nullptr;
}

}  // namespace jaywalk
