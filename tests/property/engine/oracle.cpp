// SPDX-License-Identifier: Apache-2.0
// jaywalk_oracle FIRST COUNT: random programs run alike however they are run: observed or not,
// cycle by cycle, on 1, 2 or 8 threads, in a world that says which percepts are constant or in one
// that does not. What is printed and logged, the cycles and the beliefs in the end are the same,
// and so are the inferences of programs in a world.
//
// jaywalk_oracle FIRST COUNT --write FOLDER: writes the programs, for `compare_engines`.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/environment/percepts.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"
#include "tests/property/engine/generate_reasoning.h"

namespace jaywalk {
namespace {

constexpr std::size_t kAgents = 3;

// Every fourth program is of the wilder kind, most of which fails, and every fourth perceives.
bool perceives(std::uint64_t seed) { return seed % 4 == 1; }

std::string program_of(std::uint64_t seed) {
  test::Choices choices(seed);
  if (seed % 4 == 3) return test::random_program(choices);
  return test::random_reasoning(choices, perceives(seed) ? test::Senses::some : test::Senses::none);
}

/// Some percepts change, the others are constant, whether the world says so or not.
class World : public Environment {
 public:
  World(SymbolTable& symbols, bool says_what_is_constant)
      : tick_(symbols.predicate("tick", 1)),
        c_(symbols.predicate("c", 1)),
        w_(symbols.predicate("w", 2)),
        says_what_is_constant_(says_what_is_constant) {}

  void perceive(AgentId agent, Percepts& percepts) const override {
    percepts.add(tick_, {Value::number(now_)});
    if ((now_ + static_cast<int>(agent)) % 2 == 0) percepts.add(tick_, {Value::number(9)});
    add_constants(percepts);
  }
  void constants(Percepts& percepts) const override {
    if (says_what_is_constant_) add_constants(percepts);
  }
  void execute(std::span<const ActionRequest>, std::span<ActionResult>) override {}
  void advance() override { ++now_; }
  [[nodiscard]] bool finished() const override { return now_ > 4; }
  [[nodiscard]] double tick_ms() const override { return 100; }

 private:
  void add_constants(Percepts& percepts) const {
    percepts.add(c_, {Value::number(1)});
    percepts.add(w_, {Value::number(1), Value::number(2)});
    percepts.add(w_, {Value::number(2), Value::number(3)});
    percepts.add(c_, {Value::number(3)});
    percepts.add(w_, {Value::number(4), Value::number(1)});
  }

  Predicate tick_;
  Predicate c_;
  Predicate w_;
  bool says_what_is_constant_;
  int now_ = 1;
};

struct Way {
  std::string name;
  bool is_observed = false;
  std::size_t threads = 1;
  bool by_cycles = false;          // one for each agent at a time, so that none goes on alone
  bool without_constants = false;  // of which the world says that they are
};

// A run as text; empty if the program does not compile.
std::string text_of_run(const std::string& program, std::uint64_t seed, const Way& way) {
  const auto symbols = std::make_shared<SymbolTable>();
  Diagnostics diagnostics;
  const SourceTree tree =
      load_agent(std::make_shared<const Source>("agent.asl", program), {}, diagnostics);
  const auto compiled = compile(tree, *symbols, diagnostics);
  if (compiled == nullptr) return {};
  std::string text;
  ReasoningObserver observer;
  MasOptions options;
  options.seed = seed;
  options.max_cycles = 2000;
  options.max_inferences = 50'000;
  options.max_agent_bytes = 16U << 20U;
  options.threads = way.threads;
  options.fewest_parallel = 2;
  if (way.is_observed) options.observer = &observer;
  options.print = [&](std::string_view line) { text += fmt::format("{}\n", line); };
  options.log = [&](std::string_view line) { text += fmt::format("log: {}\n", line); };
  World world(*symbols, !way.without_constants);
  Mas mas(symbols, options, perceives(seed) ? &world : nullptr);
  for (std::size_t i = 0; i < kAgents; ++i) {
    mas.add_agent({.name = fmt::format("a{}", i), .program = compiled});
  }
  while (way.by_cycles ? mas.step() : mas.stride()) {
  }
  const RunOutcome& outcome = mas.outcome();
  text += fmt::format("end {}, {} cycles {}\n", static_cast<int>(outcome.end), outcome.cycles,
                      outcome.message);
  // Where a limit ends the run, agents on other threads may have come further than they would have.
  if (outcome.end != RunEnd::idle && outcome.end != RunEnd::finished) return text;
  // Among the other programs are infinite queries (3794, 7186), which reach the memory limit some
  // inferences earlier if they are observed.
  if (perceives(seed)) text += fmt::format("{} inferences\n", outcome.inferences);
  for (std::uint32_t i = 0; i < mas.agent_count(); ++i) {
    const auto id = static_cast<AgentId>(i);
    if (!mas.is_alive(id)) continue;
    for (const std::string& belief : mas.describe_beliefs(id)) {
      text += fmt::format("{}: {}\n", i, belief);
    }
  }
  return text;
}

// Where two texts part.
std::string difference(const std::string& a, const std::string& b) {
  std::size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  const std::size_t from = at < 60 ? 0 : at - 60;
  return fmt::format("--- one\n{}\n--- other\n{}\n", a.substr(from, 160), b.substr(from, 160));
}

int check(std::uint64_t first, std::uint64_t count) {
  const std::vector<Way> ways{{"observed", true, 1},
                              {"2 threads", false, 2},
                              {"8 threads", false, 8},
                              {"cycle by cycle", false, 1, true},
                              {"without constants", false, 1, false, true},
                              {"observed without", true, 1, false, true}};
  std::uint64_t busy = 0;
  int wrong = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string program = program_of(seed);
    const std::string usual = text_of_run(program, seed, {"usual"});
    if (usual.find("] ") != std::string::npos) ++busy;
    // How much memory a context takes depends on the way in which it is solved.
    if (usual.find("memory limit") != std::string::npos) continue;
    for (const Way& way : ways) {
      const std::string other = text_of_run(program, seed, way);
      if (other == usual) continue;
      fmt::print(stderr, "seed {}: {} differs\n{}\n", seed, way.name, difference(usual, other));
      ++wrong;
    }
  }
  fmt::print("{} programs, {} of them print; {} differences\n", count, busy, wrong);
  return wrong > 0 || busy < count / 2 ? 1 : 0;  // programs that do nothing would test nothing
}

int write(std::uint64_t first, std::uint64_t count, const std::string& folder) {
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    std::ofstream(fmt::format("{}/{}.asl", folder, seed)) << program_of(seed);
  }
  return 0;
}

}  // namespace
}  // namespace jaywalk

int main(int argc, char** argv) {
  if (argc != 3 && !(argc == 5 && std::string(argv[3]) == "--write")) {
    std::fputs("Usage: jaywalk_oracle FIRST COUNT [--write FOLDER]\n", stderr);
    return 2;
  }
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  return argc == 5 ? jaywalk::write(first, count, argv[4]) : jaywalk::check(first, count);
}
