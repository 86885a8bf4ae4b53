// 12. Embedding: the interpreter within another program. Load, tell, run, ask.
//
//   cmake -B build && cmake --build build && build/12_embedding     # in this folder

#include <iostream>

#include <jaywalk/interpreter.h>

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }});
  const auto program = interpreter.load_file(EXAMPLE_DIR "/greeter.asl");
  if (!program) {
    std::cerr << program.diagnostics().render();
    return 2;
  }
  const jaywalk::AgentId ann = interpreter.add_agent("ann", program.value());
  if (!interpreter.believe(ann, "age(bob, 42)").empty()) return 1;
  if (!interpreter.achieve(ann, "greet").empty()) return 1;
  interpreter.run();
  const auto adults = interpreter.ask(ann, "adult(Name) & age(Name, Years)");
  if (!adults) return 1;
  for (const jaywalk::Answer& answer : adults.value()) {
    std::cout << answer["Name"] << " is " << *answer.find("Years")->number << '\n';
  }
}
