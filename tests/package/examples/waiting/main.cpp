// An action that takes long: the intention waits, the agent goes on with others. And an observer.
#include <iostream>
#include <string>
#include <vector>

#include <jaywalk/interpreter.h>
#include <jaywalk/observer.h>

namespace {

// Prints the plans that agents choose.
class Plans : public jaywalk::Observer {
 public:
  void plan_chosen(jaywalk::AgentView agent, const jaywalk::EventView&, const std::string& plan,
                   const jaywalk::IntentionView&) override {
    std::cout << agent.name() << " chooses " << plan << '\n';
  }
};

}  // namespace

int main() {
  Plans plans;
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; },
       .observer = plans.reasoning()});

  // my.fetch: whoever embeds the interpreter does the work between two runs.
  std::vector<std::uint32_t> waiting;
  interpreter.add_action("my.fetch", 0, 0, [&waiting](jaywalk::Call& call) {
    if (call.intention()) waiting.push_back(*call.intention());
    return call.suspend("fetching");
  });

  const auto program = interpreter.load_text("client",
                                             "!get. !rest. @get +!get <- my.fetch; ?answer(X); "
                                             ".print(X). @rest +!rest <- .print(resting).");
  if (!program) {
    std::cerr << program.diagnostics().render();
    return 2;
  }
  const jaywalk::AgentId ann = interpreter.add_agent("ann", program.value());
  interpreter.run();
  for (const std::string& goals : interpreter.intentions(ann))
    std::cout << "waits: " << goals << '\n';
  if (!interpreter.believe(ann, "answer(42)").empty()) return 1;
  if (!interpreter.resume(ann, waiting.front()).empty()) return 1;
  interpreter.run();
  std::cout << interpreter.resume(ann, waiting.front()).render();
}
