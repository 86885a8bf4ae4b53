// SPDX-License-Identifier: Apache-2.0
#include "tests/helpers/generate.h"

#include <algorithm>

namespace jaywalk::test {
namespace {

/// Writes one program. Every function appends to the text and stops nesting at depth 0.
class ProgramWriter {
 public:
  explicit ProgramWriter(Choices& choices) : choices_(choices) {}

  std::string write() {
    const std::size_t parts = 3 + choices_.below(10);
    for (std::size_t i = 0; i < parts; ++i) component();
    add("\n!a(1).\n!b.\n");
    return std::move(text_);
  }

 private:
  void add(std::string_view text) { text_ += text; }

  void component() {
    switch (choices_.below(9)) {
      case 0:
        belief();
        return;
      case 1:
        rule();
        return;
      case 2:
        add("!"), literal(2), add(".\n");
        return;
      case 3:
        directive();
        return;
      default:
        plan();
        return;
    }
  }

  void directive() {
    switch (choices_.below(3)) {
      case 0:
        add("{begin namespace(n)}\n");
        break;
      case 1:
        add("{begin bdg(a(X))}\n");
        break;
      default:
        add("{begin ebdg(b)}\n");
        break;
    }
    plan();
    if (choices_.once_in(2)) plan();
    add("{end}\n");
  }

  void name() { add(choices_.one_of({"a", "b", "c", "d"})); }
  void variable() { add(choices_.one_of({"X", "Y", "Z", "_"})); }

  void literal(int depth) {
    if (choices_.once_in(12)) add("n::");
    if (choices_.once_in(10)) add("~");
    if (choices_.once_in(30)) {
      variable();
    } else {
      name();
      if (!choices_.once_in(3)) arguments(depth);
    }
    if (choices_.once_in(6)) annotations(depth);
  }

  void arguments(int depth) {
    add("(");
    term(depth - 1);
    if (choices_.once_in(3)) add(","), term(depth - 1);
    add(")");
  }

  void annotations(int depth) {
    add("[");
    add(choices_.one_of({"a", "b(1)", "source(self)", "X", "source(S)"}));
    if (choices_.once_in(3)) add(","), literal(depth > 1 ? 1 : 0);
    if (choices_.once_in(4)) add("|T");
    add("]");
  }

  void term(int depth) {
    const std::size_t kind = choices_.below(depth > 0 ? 14 : 4);
    switch (kind) {
      case 0:
        name();
        return;
      case 1:
      case 2:
        variable();
        return;
      case 3:
        add(choices_.one_of({"0", "1", "2", "-1", "0.5", "3"}));
        return;
      case 4:
        add(choices_.one_of({"\"\"", "\"text\"", "'q'"}));
        return;
      case 5:
      case 6:
        literal(depth);
        return;
      case 7:
        list(depth);
        return;
      case 8:
      case 9:
        expression(depth);
        return;
      case 10:
        add("{ "), body(depth - 1, 2), add(" }");
        return;
      case 11:
        add("{ "), trigger(1), add(" }");
        return;
      case 12:
        add("X"), annotations(1);
        return;
      default:
        add(choices_.one_of({"math.max(X,1)", "math.abs(Y)", ".count(b)", "math.e"}));
        return;
    }
  }

  void list(int depth) {
    add("[");
    const std::size_t count = choices_.below(4);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) add(",");
      term(depth > 1 ? 1 : 0);
    }
    if (count > 0 && choices_.once_in(4)) add("|T");
    add("]");
  }

  void expression(int depth) {
    add("(");
    number(depth - 1);
    add(choices_.one_of({"+", "-", "*", "/", " div ", " mod ", "**"}));
    number(depth - 1);
    add(")");
  }

  void number(int depth) {
    if (depth > 0 && choices_.once_in(4)) {
      expression(depth);
    } else {
      add(choices_.one_of({"X", "Y", "1", "2", "0", "-1"}));
    }
  }

  void formula(int depth) {
    switch (choices_.below(depth > 0 ? 11 : 4)) {
      case 0:
        add(choices_.one_of({"true", "false"}));
        return;
      case 1:
      case 2:
      case 3:
        literal(1);
        return;
      case 4:
        add("("), formula(depth - 1), add(" & "), formula(depth - 1), add(")");
        return;
      case 5:
        add("("), formula(depth - 1), add(" | "), formula(depth - 1), add(")");
        return;
      case 6:
        add("not ("), formula(depth - 1), add(")");
        return;
      case 7:
      case 8:
        relation();
        return;
      case 9:
        variable();
        return;
      default:
        add(choices_.one_of({".member(X,[1,a,Y])", ".count(b(_),Y)", ".findall(X,b(X),Z)",
                             ".length(Z,Y)", ".ground(X)", ".list(Z)", ".range(X,1,3)",
                             ".nth(Y,[a,b],X)", ".sort(Z,Y)", ".concat(Z,[1],Y)"}));
        return;
    }
  }

  void relation() {
    term(1);
    add(choices_.one_of({" < ", " <= ", " > ", " >= ", " == ", " \\== ", " = ", " =.. "}));
    term(2);
  }

  void belief() { literal(2), add(".\n"); }

  void rule() { literal(1), add(" :- "), formula(2), add(".\n"); }

  void trigger(int depth) {
    add(choices_.one_of({"+", "-"}));
    add(choices_.one_of({"", "!", "?", "!", "!"}));
    literal(depth);
  }

  void plan() {
    if (choices_.once_in(6)) {
      add("@l" + std::to_string(++labels_));
      if (choices_.once_in(2)) add("[atomic]");
      add(" ");
    }
    trigger(2);
    if (choices_.once_in(2)) add(" : "), formula(2);
    if (choices_.once_in(25)) add(" <: "), formula(1);
    add(" <- ");
    body(2, 5);
    add(".\n");
  }

  void body(int depth, std::size_t most) {
    const std::size_t count = 1 + choices_.below(most);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) add("; ");
      step(depth);
    }
  }

  void block(int depth) { add(" { "), body(depth - 1, 3), add(" }"); }

  void step(int depth) {
    switch (choices_.below(depth > 0 ? 20 : 14)) {
      case 0:
      case 1:
      case 2:
        add(choices_.one_of({"!", "!!"})), literal(2);
        return;
      case 3:
        add("?"), formula(1);
        return;
      case 4:
      case 5:
      case 6:
        add(choices_.one_of({"+", "-", "-+", "++", "--", "+<", "+>"})), literal(2);
        return;
      case 7:
        relation();
        return;
      case 8:
        add(choices_.one_of({"X", "Y"}));
        return;
      case 9:
        literal(1);
        return;
      case 10:
        action();
        return;
      case 11:
        add("+{ "), trigger(1), add(" <- "), body(depth - 1, 2), add(" }");
        return;
      case 12:
        add("X = "), term(2);
        return;
      case 13:
        add(".print("), term(2), add(")");
        return;
      case 14:
      case 15:
        add("if ("), formula(1), add(")"), block(depth);
        if (choices_.once_in(2)) add(" else"), block(depth);
        return;
      case 16:
        add("while ("), formula(1), add(")"), block(depth);
        return;
      case 17:
        add("for ("), formula(1), add(")"), block(depth);
        return;
      case 18:
        add("("), body(depth - 1, 2), add(") |&| ("), body(depth - 1, 2), add(")");
        return;
      default:
        add("("), body(depth - 1, 2), add(") ||| ("), body(depth - 1, 2), add(")");
        return;
    }
  }

  void action() {
    switch (choices_.below(16)) {
      case 0:
        add(".fail");
        return;
      case 1:
        add(".wait(1)");
        return;
      case 2:
        add(".findall(X,"), formula(1), add(",Z)");
        return;
      case 3:
        add(".setof(X,"), formula(1), add(",Z)");
        return;
      case 4:
        add(".abolish("), literal(1), add(")");
        return;
      case 5:
        add(".send(agent,"), add(choices_.one_of({"tell", "achieve", "askOne", "untell", "askAll",
                                                  "tellHow", "signal"}));
        add(","), term(2), add(")");
        return;
      case 6:
        add(".drop_intention("), literal(1), add(")");
        return;
      case 7:
        add(".drop_desire("), literal(1), add(")");
        return;
      case 8:
        add(".succeed_goal("), literal(1), add(")");
        return;
      case 9:
        add(".fail_goal("), literal(1), add(")");
        return;
      case 10:
        add(".suspend("), literal(1), add(")");
        return;
      case 11:
        add(".resume("), literal(1), add(")");
        return;
      case 12:
        add(".add_plan("), term(2), add(")");
        return;
      case 13:
        add(".term2string(X,"), term(1), add(")");
        return;
      case 14:
        add(".concat("), term(2), add(","), term(1), add(",Y)");
        return;
      default:
        add(".wait("), formula(1), add(",2)");
        return;
    }
  }

  Choices& choices_;
  std::string text_;
  int labels_ = 0;
};

void write_term(Choices& choices, const TermKinds& kinds, int depth, std::string& out) {
  const auto inner = [&] { write_term(choices, kinds, depth - 1, out); };
  const std::size_t kind = choices.below(depth > 0 ? 10 : 5);
  if (kind == 0 && kinds.variables) {
    out += choices.one_of({"X", "Y", "Z", "W"});
  } else if (kind == 1) {
    out += choices.one_of({"0", "1", "2.5", "-3", "1000000", "1.0E20"});
  } else if (kind == 2) {
    out += choices.one_of({"\"\"", "\"s\"", "\"two words\""});
  } else if (kind < 5) {
    out += choices.one_of({"a", "b", "'Q'", "~c"});
  } else if (kind == 5 && kinds.expressions && kinds.variables) {
    out += choices.one_of({"(X+1)", "(Y*2)", "(X mod Y)", "(-Z)"});
  } else if (kind < 7) {
    out += '[';
    const std::size_t count = choices.below(4);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) out += ',';
      inner();
    }
    if (count > 0 && kinds.variables && choices.once_in(4)) out += "|W";
    out += ']';
  } else {
    out += choices.one_of({"f", "g", "~f", "n::f"});
    out += '(';
    inner();
    if (choices.once_in(2)) {
      out += ',';
      inner();
    }
    out += ')';
    if (kinds.annotations && choices.once_in(3)) {
      out += choices.one_of({"[k]", "[k,m(1)]", "[m(1),source(self)]", "[m(2)]"});
    }
  }
}

}  // namespace

std::uint64_t Choices::next() {
  state_ += 0x9E3779B97F4A7C15U;
  std::uint64_t word = state_;
  word = (word ^ word >> 30U) * 0xBF58476D1CE4E5B9U;
  word = (word ^ word >> 27U) * 0x94D049BB133111EBU;
  return word ^ word >> 31U;
}

std::string random_term(Choices& choices, const TermKinds& kinds) {
  std::string out;
  write_term(choices, kinds, kinds.depth, out);
  return out;
}

std::string random_program(Choices& choices) { return ProgramWriter(choices).write(); }

std::string mutate(Choices& choices, std::string text, std::string_view other) {
  const std::size_t changes = 1 + choices.below(4);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = choices.below(text.size());
    const std::size_t length = std::min(text.size() - at, 1 + choices.below(12));
    switch (choices.below(7)) {
      case 0:
        text[at] = static_cast<char>(choices.below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.insert(
            at, choices.one_of({"(",  ")",  "[",   "]",     "{",    "}",    ".",     ",",   ";",
                                "&",  "|",  "|&|", "|||",   "<-",   ":-",   "::",    "!",   "!!",
                                "?",  "+",  "-",   "-+",    "~",    "@",    ":",     "<:",  "\"",
                                "'",  "/*", "//",  "not ",  "if (", "elif", "begin", "end", "=..",
                                "**", "X",  "_",   "1e999", "0x",   "\\"}));
        break;
      case 4:
        std::swap(text[at], text[choices.below(text.size())]);
        break;
      case 5:
        if (!other.empty()) {
          const std::size_t from = choices.below(other.size());
          text.insert(at, other.substr(from, 1 + choices.below(40)));
        }
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

}  // namespace jaywalk::test
