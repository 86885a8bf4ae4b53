// Terms as Values: what an action finds in its arguments, and what it can make of its own.
#include <iostream>
#include <string>
#include <vector>

#include <jaywalk/interpreter.h>

using jaywalk::Call;
using jaywalk::Outcome;
using jaywalk::Terms;
using jaywalk::Value;

namespace {

// Describes a term in words.
std::string described(Value term, const Terms& terms) {
  if (term.is_number()) return "number " + std::to_string(term.as_number());
  if (term.is_text()) return "string of " + std::to_string(terms.text(term).size()) + " bytes";
  if (term.is_variable()) return "variable";
  if (term.is_list()) {
    std::string text = "list of";
    for (const Value element : terms.elements(term)) {
      text += " (" + described(element, terms) + ")";
    }
    return text;
  }
  if (!terms.is_literal(term)) return "something else";
  return (term.is_atom() ? "atom " : "structure ") + std::string(terms.functor(term)) + "/" +
         std::to_string(terms.args(term).size());
}

}  // namespace

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }});

  // Only numbers and strings are kept beyond the call, never Values.
  std::vector<std::string> kept;
  interpreter.add_action("my.describe", 1, 1, [&kept](Call& call) {
    kept.push_back(described(call.arg(0), call.terms()));
    return Outcome::succeeded;
  });

  // my.seen(Term): seen([left, "left", 1]), an atom, a string and a number in a list in a
  // structure.
  interpreter.add_action("my.seen", 1, 1, [](Call& call) {
    const Terms terms = call.terms();
    const Value list = terms.list({terms.atom("left"), terms.string("left"), Value::number(1)});
    return call.result(0, terms.structure("seen", {list}));
  });

  const auto program = interpreter.load_text(
      "values",
      "!g. +!g <- my.seen(T); .print(T); my.describe(T); my.describe([a, \"text\", 2, X]).");
  if (!program) {
    std::cerr << program.diagnostics().render();
    return 2;
  }
  const jaywalk::AgentId ann = interpreter.add_agent("ann", program.value());
  interpreter.run();
  for (const std::string& text : kept) std::cout << text << '\n';

  // An agent that is gone takes no more messages.
  if (!interpreter.include(ann, "end", "!end. +!end <- .kill_agent(ann).").empty()) return 1;
  interpreter.run();
  std::cout << interpreter.believe(ann, "p(1)").render();
}
