// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/code/head_code.h"

#include <algorithm>

namespace jaywalk {

class HeadCode::Compiler {
 public:
  Compiler(HeadCode& code, std::span<const Symbol> names)
      : code_(code),
        names_(names),
        uses_(names.size(), 0),
        is_set_(names.size(), false),
        in_templates_(names.size(), false) {}

  // Counts the places of each slot in a template of a program's text, which nests less deep than
  // the stack.
  void count(Value term) {
    if (term.is_closed()) return;
    if (term.is_slot()) {
      ++uses_[term.slot_index()];
    } else if (term.is_pair()) {
      for (; term.is_pair(); term = term.pair()->tail) count(term.pair()->head);
      count(term);
    } else if (term.is_structure()) {
      for (const Value arg : term.structure()->arg_span()) count(arg);
      count(term.structure()->annots());
    }
  }

  // Every variable counts as if it stood somewhere else, too.
  void keep_all() { std::ranges::fill(uses_, 2); }
  // The slot has a value before the head is matched.
  void leave_to_templates(std::uint32_t slot) { in_templates_[slot] = true; }

  void compile(const Structure& head) {
    code_.steps_.clear();
    for (std::uint16_t i = 0; i < head.arity; ++i) {
      HeadStep step = step_for(head.arg(i));
      step.argument = i;
      const bool is_list = head.arg(i).is_pair() && !head.arg(i).is_closed();
      if (is_list) step.kind = HeadStep::Kind::pair;
      const bool tells_apart =
          step.kind == HeadStep::Kind::pair || step.kind == HeadStep::Kind::constant;
      if (i > 0 && tells_apart) code_.tests_.push_back(step);
      add(step);
      if (!is_list) continue;
      const std::size_t place = code_.steps_.size() - 1;
      add(step_for(head.arg(i).pair()->head));
      add(step_for(head.arg(i).pair()->tail));
      code_.steps_[place].kind = kind_of_pair(code_.steps_[place + 1], code_.steps_[place + 2]);
    }
    code_.first_to_clear_ = 0;
    while (code_.first_to_clear_ < is_set_.size() && is_set_[code_.first_to_clear_]) {
      ++code_.first_to_clear_;
    }
    code_.steps_.push_back({.kind = HeadStep::Kind::end});
  }

 private:
  [[nodiscard]] HeadStep step_for(Value term) const {
    if (term.is_slot()) {
      const std::uint32_t slot = term.slot_index();
      return {.kind = kind_of(slot), .slot = slot, .term = term};
    }
    const bool is_constant =
        term.is_number() || term.is_empty_list() || (term.is_atom() && !is_foreign(term.atom_id()));
    return {.kind = is_constant ? HeadStep::Kind::constant : HeadStep::Kind::term, .term = term};
  }

  [[nodiscard]] static HeadStep::Kind kind_of_pair(const HeadStep& head, const HeadStep& tail) {
    using enum HeadStep::Kind;
    if (tail.kind != first) return pair;
    return head.kind == first ? new_pair : head.kind == again ? known_pair : pair;
  }

  // A slot that a template mentions before it has a step is left to templates altogether.
  [[nodiscard]] HeadStep::Kind kind_of(std::uint32_t slot) const {
    if (is_set_[slot]) return HeadStep::Kind::again;
    if (has_unknown_template_ || in_templates_[slot]) return HeadStep::Kind::term;
    const bool is_alone = uses_[slot] == 1 && names_[slot] == names::unnamed;
    return is_alone ? HeadStep::Kind::any : HeadStep::Kind::first;
  }

  void add(const HeadStep& step) {
    if (step.kind == HeadStep::Kind::first) is_set_[step.slot] = true;
    if (step.kind == HeadStep::Kind::term && !step.term.is_closed()) {
      // Terms of run-time data may share their parts, so that to walk through them never ends.
      step.term.is_slot() || step.term.is_static() ? note(step.term)
                                                   : void(has_unknown_template_ = true);
    }
    code_.steps_.push_back(step);
  }

  void note(Value term) {
    if (term.is_closed()) return;
    if (term.is_slot()) {
      in_templates_[term.slot_index()] = true;
    } else if (term.is_pair()) {
      for (; term.is_pair(); term = term.pair()->tail) note(term.pair()->head);
      note(term);
    } else if (term.is_structure()) {
      for (const Value arg : term.structure()->arg_span()) note(arg);
      note(term.structure()->annots());
    }
  }

  HeadCode& code_;
  std::span<const Symbol> names_;
  std::vector<std::uint32_t> uses_;
  std::vector<bool> is_set_;           // by a step `first`
  std::vector<bool> in_templates_;     // mentioned by a step `term`
  bool has_unknown_template_ = false;  // it may mention any slot
};

HeadCode::HeadCode(Value head, const std::vector<Value>& body_terms,
                   std::span<const Symbol> slot_names)
    : HeadCode() {
  if (!head.is_structure()) return;
  Compiler compiler(*this, slot_names);
  if (head.is_static()) {
    compiler.count(head);
    for (const Value term : body_terms) compiler.count(term);
  } else {
    compiler.keep_all();
  }
  compiler.compile(*head.structure());
}

HeadCode HeadCode::of_plan(Value head, std::span<const Symbol> slot_names,
                           std::span<const std::uint32_t> inherits) {
  HeadCode code;
  code.is_of_plan_ = true;
  if (!head.is_structure()) return code;
  Compiler compiler(code, slot_names);
  compiler.keep_all();
  for (const std::uint32_t slot : inherits) compiler.leave_to_templates(slot);
  compiler.compile(*head.structure());
  return code;
}

}  // namespace jaywalk
