// Custom selection functions: urgent goals go first.
#include <interpreter/agent/agent.h>
#include <interpreter/embed/interpreter.h>
#include <iostream>

namespace {

// The number in an annotation priority(N) of a plan's label; 0 if there is none.
double priority(const jaywalk::Plan& plan, const jaywalk::Agent& agent) {
  jaywalk::Value rest = literal_parts(plan.label).annots;
  for (; rest.is_pair(); rest = deref(rest.pair()->tail)) {
    const jaywalk::Value annot = deref(rest.pair()->head);
    if (!jaywalk::is_literal(annot)) continue;
    const jaywalk::LiteralParts parts = literal_parts(annot);
    if (agent.symbols().functor(parts.predicate) == "priority" && parts.args.size() == 1 &&
        parts.args[0].is_number()) {
      return parts.args[0].as_number();
    }
  }
  return 0;
}

// The place of the element for which `value` is greatest; the first of equals.
template <class List, class ValueOf>
std::size_t best(const List& list, ValueOf value) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (value(list[i]) > value(list[found])) found = i;
  }
  return found;
}

jaywalk::Customisation urgency() {
  jaywalk::Customisation functions;
  // Beliefs about the world before goals.
  functions.select_event = [](jaywalk::Agent&, const jaywalk::Ring<jaywalk::Event>& events) {
    return best(events, [](const jaywalk::Event& event) {
      return event.kind == jaywalk::TriggerKind::belief ? 1 : 0;
    });
  };
  // The applicable plan with the highest priority.
  functions.select_option = [](jaywalk::Agent& agent, const jaywalk::Event&,
                               std::span<const jaywalk::Option> options) {
    return best(options,
                [&](const jaywalk::Option& option) { return priority(*option.plan, agent); });
  };
  // The intention whose plan has the highest priority, until it is done.
  functions.select_intention = [](jaywalk::Agent& agent,
                                  const jaywalk::Ring<jaywalk::Intention*>& ready) {
    return best(ready, [&](const jaywalk::Intention* intention) {
      return priority(*intention->top().plan, agent);
    });
  };
  return functions;
}

}  // namespace

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }});
  const auto program = interpreter.load_file(EXAMPLE_DIR "/walker.asl");
  if (!program) {
    std::cerr << program.diagnostics().render();
    return 2;
  }
  interpreter.add_agent("plain", program.value());
  interpreter.run();
  const auto functions = std::make_shared<const jaywalk::Customisation>(urgency());
  interpreter.add_agent("urgent", program.value(), functions);
  interpreter.run();
}
