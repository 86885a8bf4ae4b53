// Custom selection functions: urgent goals go first.
#include <iostream>
#include <span>

#include <jaywalk/interpreter.h>

using jaywalk::AgentView;
using jaywalk::EventView;
using jaywalk::IntentionView;
using jaywalk::OptionView;
using jaywalk::Terms;
using jaywalk::Value;

namespace {

// The number in an annotation priority(N) of a plan's label; 0 if there is none.
double priority(Value label, const Terms& terms) {
  for (const Value annotation : terms.annotations(label)) {
    const std::vector<Value> args = terms.args(annotation);
    if (terms.functor(annotation) == "priority" && args.size() == 1 && args[0].is_number()) {
      return args[0].as_number();
    }
  }
  return 0;
}

// The place of the element for which `value` is greatest; the first of equals.
template <class Element, class ValueOf>
std::size_t best(std::span<const Element> elements, ValueOf value) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < elements.size(); ++i) {
    if (value(elements[i]) > value(elements[found])) found = i;
  }
  return found;
}

jaywalk::AgentClass urgency() {
  jaywalk::AgentClass functions;
  // Beliefs about the world before goals.
  functions.select_event = [](AgentView, std::span<const EventView> events) {
    return best(events, [](const EventView& event) {
      return event.kind == EventView::Kind::belief ? 1 : 0;
    });
  };
  // The applicable plan with the highest priority.
  functions.select_option = [](AgentView agent, const EventView&,
                               std::span<const OptionView> options) {
    return best(options,
                [&](const OptionView& option) { return priority(option.label, agent.terms()); });
  };
  // The intention whose plan has the highest priority, until it is done.
  functions.select_intention = [](AgentView agent, std::span<const IntentionView> ready) {
    return best(ready, [&](const IntentionView& intention) {
      return priority(intention.label, agent.terms());
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
  interpreter.add_agent("urgent", program.value(), urgency());
  interpreter.run();
}
