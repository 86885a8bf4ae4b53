// Custom belief revision and social acceptance.
#include <iostream>
#include <string_view>

#include <jaywalk/interpreter.h>

namespace {

jaywalk::AgentClass caution() {
  jaywalk::AgentClass functions;
  // There is one position at a time: a new one takes the old one's place. Rumours are not believed.
  functions.revise_beliefs = [](jaywalk::Revision& revision) {
    const jaywalk::Terms terms = revision.agent().terms();
    const std::string_view functor = terms.functor(revision.literal());
    if (functor == "rumour") return;
    if (functor == "position" && revision.is_addition()) {
      revision.remove(terms.structure("position", {terms.variable()}));
    }
    revision.accept();
  };
  // Orders are taken from the boss alone.
  functions.accepts_message = [](jaywalk::AgentView, const jaywalk::MessageView& message) {
    return message.performative != "achieve" || message.sender == "boss";
  };
  return functions;
}

}  // namespace

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }});
  const auto guard = interpreter.load_file(EXAMPLE_DIR "/guard.asl");
  const auto talker = interpreter.load_file(EXAMPLE_DIR "/talker.asl");
  if (!guard || !talker) return 2;
  interpreter.add_agent("guard", guard.value(), caution());
  interpreter.add_agent("thief", talker.value());
  interpreter.add_agent("boss", talker.value());
  interpreter.run();
}
