// Custom belief revision and social acceptance.
#include <interpreter/agent/agent.h>
#include <interpreter/embed/interpreter.h>
#include <iostream>

namespace {

jaywalk::Customisation caution() {
  jaywalk::Customisation functions;
  // There is one position at a time: a new one takes the old one's place. Rumours are not believed.
  functions.revise_beliefs = [](jaywalk::BeliefRevision& revision) {
    jaywalk::Agent& agent = revision.agent();
    const jaywalk::LiteralParts belief = literal_parts(revision.literal());
    const std::string_view functor = agent.symbols().functor(belief.predicate);
    if (functor == "rumour") return;
    if (functor == "position" && revision.kind() == jaywalk::BeliefRevision::Kind::add) {
      const jaywalk::Value anywhere = agent.heap().variable();
      const std::span<const jaywalk::Value> args(&anywhere, 1);
      revision.remove(agent.heap().structure(belief.predicate, args));
    }
    revision.accept();
  };
  // Orders are taken from the boss alone.
  functions.accepts_message = [](jaywalk::Agent& agent, const jaywalk::Message& message) {
    return agent.symbols().text(message.performative) != "achieve" || message.sender == "boss";
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
  interpreter.add_agent("guard", guard.value(),
                        std::make_shared<const jaywalk::Customisation>(caution()));
  interpreter.add_agent("thief", talker.value());
  interpreter.add_agent("boss", talker.value());
  interpreter.run();
}
