// A custom world: a room that cools, and a heater for one agent.
#include <iostream>
#include <memory>

#include <jaywalk/interpreter.h>

namespace {

class Room : public jaywalk::Environment {
 public:
  explicit Room(jaywalk::SymbolTable& symbols)
      : temperature_(predicate_named(symbols, "temperature", 1)),
        heat_(predicate_named(symbols, "heat", 1)),
        rest_(predicate_named(symbols, "rest", 0)) {}

  void perceive(jaywalk::AgentId, jaywalk::Percepts& percepts) const override {
    add_percept(percepts, temperature_, {jaywalk::Value::number(degrees_)});
  }

  void execute(std::span<const jaywalk::ActionRequest> actions,
               std::span<jaywalk::ActionResult> results) override {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      if (actions[i].predicate == heat_ && actions[i].args[0].is_number()) {
        degrees_ += actions[i].args[0].as_number();
      } else if (actions[i].predicate != rest_) {
        results[i] = {.succeeded = false, .reason = "the room has no such switch"};
      }
    }
  }

  void advance() override { degrees_ -= 1, ++minutes_; }
  [[nodiscard]] bool finished() const override { return minutes_ == 6; }
  [[nodiscard]] double tick_ms() const override { return 60'000; }

 private:
  jaywalk::Predicate temperature_;
  jaywalk::Predicate heat_;
  jaywalk::Predicate rest_;
  double degrees_ = 20;
  int minutes_ = 0;
};

}  // namespace

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }},
      [](jaywalk::SymbolTable& symbols) { return std::make_unique<Room>(symbols); });
  const auto program = interpreter.load_file(EXAMPLE_DIR "/heater.asl");
  if (!program) {
    std::cerr << program.diagnostics().render();
    return 2;
  }
  interpreter.add_agent("heater", program.value());
  const jaywalk::RunOutcome outcome = interpreter.run();
  std::cout << outcome.ticks << " minutes\n";
}
