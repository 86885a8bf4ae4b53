// Terms as Values: what an action finds in its arguments, and what it can make of its own.
#include <interpreter/embed/interpreter.h>
#include <interpreter/logic/action.h>
#include <iostream>
#include <string>
#include <vector>

using jaywalk::ActionCall;
using jaywalk::Outcome;
using jaywalk::Value;

namespace {

// Describes a term in words. A list is a chain of pairs, each with a head and a tail.
std::string described(Value term, ActionCall& call) {
  term = deref(term);
  if (term.is_number()) return "number " + std::to_string(term.as_number());
  if (term.is_text()) return "string of " + std::to_string(term.text()->view().size()) + " bytes";
  if (term.is_variable()) return "variable";
  if (term.is_list()) {
    std::string text = "list of";
    for (; term.is_pair(); term = deref(term.pair()->tail)) {
      text += " (" + described(term.pair()->head, call) + ")";
    }
    return text;
  }
  if (!jaywalk::is_literal(term)) return "something else";
  const jaywalk::LiteralParts parts = literal_parts(term);
  const std::string functor(call.symbols().functor(parts.predicate));
  return (term.is_atom() ? "atom " : "structure ") + functor + "/" +
         std::to_string(parts.args.size());
}

}  // namespace

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }});

  // Only numbers and strings are kept beyond the call, never Values.
  std::vector<std::string> kept;
  interpreter.add_action("my.describe", 1, 1, [&kept](ActionCall& call) {
    kept.push_back(described(call.arg(0), call));
    return Outcome::succeeded;
  });

  // my.seen(Term): seen([left, "left", 1]), an atom, a string and a number in a list in a
  // structure.
  interpreter.add_action("my.seen", 1, 1, [](ActionCall& call) {
    const Value left = Value::atom(call.symbols().predicate("left", 0));
    const std::vector<Value> elements{left, call.heap().text("left"), Value::number(1)};
    const Value list = call.heap().list(elements);
    const std::vector<Value> args{list};
    return call.result(0, call.heap().structure(call.symbols().predicate("seen", 1), args));
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
