// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/print.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include <fmt/format.h>

#include "interpreter/support/text.h"
#include "interpreter/term/walk.h"

namespace jaywalk {
namespace {

double rounded(double number) {
  const std::string text = fmt::format("{:.12g}", number);
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

class Printer {
 public:
  enum class Strings { as_they_are, escaped };
  enum class Numbers { exact, rounded };
  Printer(std::string& out, const SymbolTable& symbols, Strings strings = Strings::as_they_are,
          std::size_t most = kMaxTextBytes, Numbers numbers = Numbers::exact)
      : out_(out), symbols_(symbols), strings_(strings), most_(most), numbers_(numbers) {}

  void whole(Value value) {
    const std::size_t begin = out_.size();
    try {
      term(value);
    } catch (const TermTooDeep&) {
      circles_ = circles_of(value);
      if (circles_.empty()) throw;
      out_.resize(begin);
      unnamed_.clear();
      is_cut_ = false;
      term(value);
    }
  }

  void term(Value value) {
    value = deref(value);
    if (!circles_.empty()) {
      const auto circle = circles_.find(value.bits());
      if (circle != circles_.end()) return circular(value, *circle->second);
    }
    parts(value);
  }

  /// Something was left out, for want of room.
  [[nodiscard]] bool is_cut() const { return is_cut_; }

 private:
  // As Jason has it, "...f(X)/X": the term f(X) that is the value of its X.
  void circular(Value value, const Variable& name) {
    const bool is_within = std::ranges::find(within_, value.bits()) != within_.end();
    if (!is_within) {
      within_.push_back(value.bits());
      out_ += "...";
      parts(value);
      out_ += '/';
      within_.pop_back();
    }
    variable(name);
  }

  // Not in line, as variable(): the text of a number takes much of the stack.
  [[gnu::noinline]] void number(double number) {
    append_number(out_, numbers_ == Numbers::exact ? number : rounded(number));
  }

  void parts(Value value) {
    switch (value.kind()) {
      case Value::Kind::number:
        number(value.as_number());
        return;
      case Value::Kind::atom:
        name(value.atom_id());
        return;
      case Value::Kind::text:
        out_ += '"';
        text(value.text()->view());
        out_ += '"';
        return;
      case Value::Kind::variable:
        variable(*value.variable());
        return;
      case Value::Kind::special:
        special(value);
        return;
      case Value::Kind::object:
      case Value::Kind::pair:
      case Value::Kind::structure:
        break;
    }
    if (is_enough()) return;
    // Bounds the depth, and with it the stack.
    const TermWalk::Level level(walk_, value.is_object() ? Value() : value);
    if (value.is_object()) {
      object(*value.object()->object);
    } else if (value.is_pair()) {
      list(value, '[', ']');
    } else {
      structure(*value.structure());
    }
  }

  // A term that shares its parts may be small, and its text longer than any memory. What would
  // stand behind the limit is left out; an exception would take its time through all levels of the
  // term.
  bool is_enough() {
    const bool is_long = out_.size() > most_;
    is_cut_ = is_cut_ || is_long;
    return is_long;
  }

  // A variable without a name gets a number, in the order of the text: the number of its creation
  // would depend on the engine's way, which differs with and without observers. Not in line: its
  // stack space would be taken on every level of a term.
  [[gnu::noinline]] void variable(const Variable& variable) {
    if (variable.name() != names::unnamed) {
      out_ += symbols_.text(variable.name());
      return;
    }
    auto found = std::find(unnamed_.begin(), unnamed_.end(), &variable);
    if (found == unnamed_.end()) found = unnamed_.insert(found, &variable);
    out_ += fmt::format("_{}", found - unnamed_.begin() + 1);
  }

  void text(std::string_view content) {
    if (strings_ == Strings::as_they_are) {
      out_ += content;
      return;
    }
    for (const char c : content) {
      // Only these two: a backslash stays as it is, since reading leaves it, too (builder.cpp).
      if (c == '"') out_ += '\\';
      c == '\n' ? out_ += "\\n" : out_ += c;
    }
  }

  void special(Value value) {
    if (value.is_empty_list()) {
      out_ += "[]";
    } else if (value.is_slot()) {
      out_ += fmt::format("_{}", value.slot_index());
    } else {
      out_ += '_';
    }
  }

  void name(Predicate predicate) {
    const Signature& signature = symbols_.signature(predicate);
    if (signature.ns != names::default_ns) {
      out_ += symbols_.text(signature.ns);
      out_ += "::";
    }
    if (signature.negated) out_ += '~';
    out_ += symbols_.text(signature.functor);
  }

  void list(Value value, char open, char close) {
    out_ += open;
    bool first = true;
    ListWalk walk;
    for (value = deref(value); value.is_pair(); value = deref(value.pair()->tail)) {
      if (!first && circles_.contains(value.bits())) break;
      // A list that contains itself would never end (walk.h).
      walk.visit(value);
      walk_.visit();
      if (is_enough()) return;
      if (!first) out_ += ',';
      first = false;
      term(value.pair()->head);
    }
    if (!value.is_empty_list()) {
      out_ += '|';
      term(value);
    }
    out_ += close;
  }

  void args(const Structure& s) {
    if (s.arity == 0) return;
    out_ += '(';
    for (std::size_t i = 0; i < s.arity && !is_enough(); ++i) {
      if (i > 0) out_ += ',';
      term(s.arg(i));
    }
    out_ += ')';
  }

  void annots(const Structure& s) {
    const Value set = deref(s.annots());
    if (set.is_pair() || (s.is_annotated() && set.is_variable())) {
      if (set.is_pair()) {
        list(set, '[', ']');
      } else {
        out_ += "[|";
        term(set);
        out_ += ']';
      }
    }
  }

  void structure(const Structure& s) {
    switch (s.form()) {
      case Form::literal:
      case Form::function:
        name(s.predicate());
        args(s);
        annots(s);
        return;
      case Form::expression:
        expression(s);
        return;
      case Form::relation:
      case Form::logical:
        formula(s);
        return;
      case Form::decorated:
        decorated(s);
        return;
      case Form::body:
        body(s);
        return;
      case Form::step:
        step(s);
        return;
      case Form::trigger: {
        const bool bare = is_bare(s);
        if (!bare) out_ += "{ ";
        trigger(s);
        if (!bare) out_ += " }";
        return;
      }
      case Form::plan:
        plan(s);
        return;
      case Form::rule:
        out_ += "{ ";
        term(s.arg(0));
        out_ += " :- ";
        term(s.arg(1));
        out_ += " }";
        return;
    }
  }

  void expression(const Structure& s) {
    out_ += '(';
    if (s.arity == 1) {
      out_ += symbols_.functor(s.predicate());
      term(s.arg(0));
    } else {
      term(s.arg(0));
      const std::string_view op = symbols_.functor(s.predicate());
      const bool word = op == "mod" || op == "div";
      if (word) out_ += ' ';
      out_ += op;
      if (word) out_ += ' ';
      term(s.arg(1));
    }
    out_ += ')';
  }

  void formula(const Structure& s) {
    if (s.arity == 1) {
      out_ += "not (";
      term(s.arg(0));
      out_ += ')';
      return;
    }
    out_ += '(';
    term(s.arg(0));
    out_ += ' ';
    out_ += symbols_.functor(s.predicate());
    out_ += ' ';
    term(s.arg(1));
    out_ += ')';
  }

  void decorated(const Structure& s) {
    if (s.arity > 1) {
      term(s.arg(1));
      out_ += "::";
    }
    if (symbols_.signature(s.predicate()).negated) out_ += '~';
    term(s.arg(0));
    annots(s);
  }

  void step(const Structure& s) {
    out_ += symbols_.functor(s.predicate());
    term(s.arg(0));
  }

  void steps(const Structure& s) {
    for (std::size_t i = 0; i < s.arity && !is_enough(); ++i) {
      if (i > 0) out_ += "; ";
      const Value inner = body_of(s.arg(i));
      inner.is_unset() ? term(s.arg(i)) : steps(*inner.structure());
    }
  }

  // A variable's body that stands as a formula: it is a part of the enclosing one.
  [[nodiscard]] Value body_of(Value step) const {
    step = deref(step);
    const bool is_step = is_form(step, Form::step) &&
                         symbols_.signature(step.structure()->predicate()).functor == names::empty;
    const Value formula = is_step ? deref(step.structure()->arg(0)) : step;
    const bool is_part = is_form(formula, Form::body) && formula.structure()->arity > 0;
    return is_part ? formula : Value();
  }

  // Text that must be readable again keeps its braces.
  [[nodiscard]] bool is_bare(const Structure& s) const {
    return (s.info & Structure::kBare) != 0 && strings_ == Strings::as_they_are;
  }

  void body(const Structure& s) {
    const bool bare = is_bare(s);
    if (!bare) out_ += "{ ";
    steps(s);
    if (!bare) out_ += s.arity > 0 ? " }" : "}";
  }

  void trigger(const Structure& s) {
    out_ += symbols_.functor(s.predicate());
    term(s.arg(0));
  }

  void plan(const Structure& s) {
    const bool bare = is_bare(s);
    if (!bare) out_ += "{ ";
    const Value label = deref(s.arg(0));
    if (!label.is_unset()) {
      out_ += '@';
      term(label);
      out_ += ' ';
    }
    const Value trigger_term = deref(s.arg(1));
    trigger_term.is_structure() && trigger_term.structure()->form() == Form::trigger
        ? trigger(*trigger_term.structure())
        : term(trigger_term);
    const Value context = deref(s.arg(2));
    if (!context.is_unset()) {
      out_ += " : ";
      term(context);
    }
    const Value body_term = deref(s.arg(3));
    if (body_term.is_structure() && body_term.structure()->form() == Form::body) {
      if (body_term.structure()->arity > 0) {
        out_ += " <- ";
        steps(*body_term.structure());
      }
    } else if (!body_term.is_unset()) {
      out_ += " <- ";
      term(body_term);
    }
    out_ += bare ? "." : " }";
  }

  void object(Object& object) {
    std::string inner;
    const bool queue = object.kind() == Object::Kind::queue;
    bool first = true;
    bool key = true;
    std::string& out = out_;
    out += queue ? '[' : '{';
    object.visit([&](Value& value) {
      if (is_enough()) return;
      const bool is_map = object.kind() == Object::Kind::map;
      if (!first) out += is_map && !key ? "->" : queue ? ", " : ",";
      first = false;
      key = !key;
      term(value);
    });
    out += queue ? ']' : '}';
  }

  std::string& out_;
  const SymbolTable& symbols_;
  Strings strings_;
  std::size_t most_;
  Numbers numbers_;
  bool is_cut_ = false;
  TermWalk walk_;
  std::vector<const Variable*> unnamed_;
  Circles circles_;  // of a term that has some
  std::vector<std::uint64_t> within_;
};

std::string beginning(Value term, const SymbolTable& symbols, std::size_t most,
                      Printer::Numbers numbers) {
  std::string out;
  try {
    Printer(out, symbols, Printer::Strings::as_they_are, most, numbers).whole(term);
  } catch (const HeapExhausted&) {
    return out + "...";  // a walk that is too long, not a text
  }
  return shortened(out, most);
}

void print_whole(Printer printer, Value term) {
  printer.whole(term);
  if (printer.is_cut()) throw HeapExhausted{};
}

}  // namespace

void append_term(std::string& out, Value term, const SymbolTable& symbols) {
  print_whole(Printer(out, symbols), term);
}

std::string term_text(Value term, const SymbolTable& symbols) {
  std::string out;
  append_term(out, term, symbols);
  return out;
}

std::string brief_text(Value term, const SymbolTable& symbols, std::size_t most) {
  return beginning(term, symbols, most, Printer::Numbers::exact);
}

std::string rounded_text(Value term, const SymbolTable& symbols, std::size_t most) {
  return beginning(term, symbols, most, Printer::Numbers::rounded);
}

std::string source_text(Value term, const SymbolTable& symbols) {
  std::string out;
  print_whole(Printer(out, symbols, Printer::Strings::escaped), term);
  return out;
}

void append_argument(std::string& out, Value term, const SymbolTable& symbols) {
  term = deref(term);
  if (term.is_text()) {
    out += term.text()->view();
  } else if (term.is_variable()) {
    append_term(out, term, symbols);
    out += "<no-value>";
  } else {
    append_term(out, term, symbols);
  }
}

}  // namespace jaywalk
