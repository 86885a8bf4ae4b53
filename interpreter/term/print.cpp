#include "interpreter/term/print.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "interpreter/support/text.h"
#include "interpreter/term/walk.h"

namespace jaywalk {
namespace {

// Java's Double.toString: the shortest digits that give the number back, but at least two, which
// makes a difference for the least numbers of all (4.9E-324).
void append_java_double(std::string& out, double value) {
  std::array<char, 40> buffer{};
  char* const limit = buffer.data() + buffer.size();
  auto end = std::to_chars(buffer.data(), limit, value, std::chars_format::scientific);
  if (std::fpclassify(value) == FP_SUBNORMAL &&
      std::string_view(buffer.data(), end.ptr).find('.') == std::string_view::npos) {
    end = std::to_chars(buffer.data(), limit, value, std::chars_format::scientific, 1);
  }
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  // C++ writes d.ddde+dd; Java wants plain digits from 1e-3 to below 1e7, else d.dddEd.
  const std::size_t exponent_at = text.find('e');
  int exponent = 0;
  const std::string_view exponent_text = text.substr(exponent_at + 1);
  std::from_chars(exponent_text.data() + (exponent_text.front() == '+' ? 1 : 0),
                  exponent_text.data() + exponent_text.size(), exponent);
  std::string_view mantissa = text.substr(0, exponent_at);
  if (mantissa.front() == '-') {
    out += '-';
    mantissa.remove_prefix(1);
  }
  std::string digits(mantissa.substr(0, 1));
  if (mantissa.size() > 2) digits += mantissa.substr(2);
  const auto count = static_cast<int>(digits.size());
  if (exponent < -3 || exponent >= 7) {
    out += digits[0];
    out += '.';
    out += count > 1 ? digits.substr(1) : "0";
    out += fmt::format("E{}", exponent);
  } else if (exponent < 0) {
    out += "0.";
    out.append(static_cast<std::size_t>(-exponent - 1), '0');
    out += digits;
  } else {
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    if (digits.size() <= whole) digits.append(whole - digits.size() + 1, '0');
    out.append(digits, 0, whole);
    out += '.';
    out.append(digits, whole);
  }
}

constexpr double kLongLimit = 9223372036854775808.0;

class Printer {
 public:
  enum class Strings { as_they_are, escaped };
  Printer(std::string& out, const SymbolTable& symbols, Strings strings = Strings::as_they_are,
          std::size_t most = kMaxTextBytes)
      : out_(out), symbols_(symbols), strings_(strings), most_(most) {}

  void term(Value value) {
    value = deref(value);
    switch (value.kind()) {
      case Value::Kind::number:
        append_number(out_, value.as_number());
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
    // Bounds the depth, and with it the stack.
    const TermWalk::Level level(walk_);
    check_length();
    if (value.is_object()) {
      object(*value.object()->object);
    } else if (value.is_pair()) {
      list(value, '[', ']');
    } else {
      structure(*value.structure());
    }
  }

 private:
  // A term that shares its parts may be small, and its text longer than any memory.
  void check_length() const {
    if (out_.size() > most_) throw HeapExhausted{};
  }

  // What has no name gets a number, in the order of the text: the number of its making would show
  // how the engine came to it, which differs with and without observers. Not in line: the stack it
  // takes would be taken on every level of a term.
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
      // A list that contains itself would never end (walk.h).
      walk.visit(value);
      walk_.visit();
      check_length();
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
    for (std::size_t i = 0; i < s.arity; ++i) {
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
    for (std::size_t i = 0; i < s.arity; ++i) {
      if (i > 0) out_ += "; ";
      const Value inner = body_of(s.arg(i));
      inner.is_unset() ? term(s.arg(i)) : steps(*inner.structure());
    }
  }

  // The body that a variable has become in the place of a formula: it is a part of the one around.
  [[nodiscard]] Value body_of(Value step) const {
    step = deref(step);
    const bool is_step = is_form(step, Form::step) &&
                         symbols_.signature(step.structure()->predicate()).functor == names::empty;
    const Value formula = is_step ? deref(step.structure()->arg(0)) : step;
    const bool is_part = is_form(formula, Form::body) && formula.structure()->arity > 0;
    return is_part ? formula : Value();
  }

  // What is to be read again has its braces.
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
  TermWalk walk_;
  std::vector<const Variable*> unnamed_;
};

}  // namespace

void append_number(std::string& out, double value) {
  if (std::isnan(value)) {
    out += "NaN";
  } else if (std::isinf(value)) {
    out += value > 0 ? "Infinity" : "-Infinity";
  } else if (value == std::floor(value) && std::fabs(value) < kLongLimit) {
    out += fmt::format("{}", static_cast<std::int64_t>(value));
  } else if (value == kLongLimit) {
    out += "9223372036854775807";  // Math.round saturates
  } else if (value == -kLongLimit) {
    out += "-9223372036854775808";
  } else {
    append_java_double(out, value);
  }
}

std::string number_text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

void append_term(std::string& out, Value term, const SymbolTable& symbols) {
  Printer(out, symbols).term(term);
}

std::string term_text(Value term, const SymbolTable& symbols) {
  std::string out;
  append_term(out, term, symbols);
  return out;
}

std::string brief_text(Value term, const SymbolTable& symbols, std::size_t most) {
  std::string out;
  try {
    Printer(out, symbols, Printer::Strings::as_they_are, most).term(term);
  } catch (const HeapExhausted&) {
    if (out.size() <= most) return out + "...";  // a walk that is too long, not a text
  }
  return shortened(out, most);
}

std::string source_text(Value term, const SymbolTable& symbols) {
  std::string out;
  Printer(out, symbols, Printer::Strings::escaped).term(term);
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
