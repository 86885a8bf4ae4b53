// Custom internal actions and a custom function.
#include <iostream>

#include <jaywalk/interpreter.h>

using jaywalk::Call;
using jaywalk::Outcome;
using jaywalk::Value;

int main() {
  jaywalk::Interpreter interpreter(
      {.print = [](std::string_view line) { std::cout << line << '\n'; }});

  // road.braking_distance(Speed, Metres): one result. It keeps what it needs in what it captures.
  int asked = 0;
  interpreter.add_action("road.braking_distance", 2, 2, [&asked](Call& call) {
    constexpr double kDeceleration = 6.5;  // m/s^2
    if (!call.arg(0).is_number()) return call.wrong_argument(0, "a speed in m/s");
    const double speed = call.arg(0).as_number();
    if (speed < 0) return Outcome::failed;
    ++asked;
    return call.result(1, Value::number(speed * speed / (2 * kDeceleration)));
  });

  // road.lane(Lane): a solution for each lane, found by backtracking.
  interpreter.add_action("road.lane", 1, 1, [](Call& call) {
    return call.each([lane = 0](Call& again) mutable {
      return lane < 3 && again.unify(0, Value::number(++lane));
    });
  });

  // road.kmh(Speed): a function, to be used within expressions.
  interpreter.add_function({.name = "road.kmh",
                            .least_args = 1,
                            .most_args = 1,
                            .function = [](std::span<const Value> args, jaywalk::Heap&,
                                           jaywalk::SymbolTable&, Value& result) {
                              if (!args[0].is_number()) return false;
                              result = Value::number(args[0].as_number() * 3.6);
                              return true;
                            }});

  const auto program = interpreter.load_file(EXAMPLE_DIR "/driver.asl");
  if (!program) {
    std::cerr << program.diagnostics().render();
    return 2;
  }
  interpreter.add_agent("driver", program.value());
  interpreter.run();
  std::cout << "asked " << asked << " times\n";
}
