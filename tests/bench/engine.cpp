// SPDX-License-Identifier: Apache-2.0
// The parts of the engine by themselves, with Google Benchmark: parser, unifier, belief base,
// cycle, percepts. Each counts what it gets done a second; bytes for the parser.

#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "interpreter/compile/compiler.h"
#include "interpreter/environment/percepts.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

void count_items(benchmark::State& state, std::int64_t each) {
  state.SetItemsProcessed(state.iterations() * each);
}

// 4 MB of plans such as people write.
void Parse(benchmark::State& state) {
  constexpr std::size_t kBytes = 4'000'000;
  std::string text;
  for (int i = 0; text.size() < kBytes; ++i) {
    text += fmt::format(
        "at({0}, {1})[source(percept)].\n"
        "+!go(X, Y)[source(S)] : at(X{0}, Y) & not blocked(X, \"north {0}\") & X < {1} + 2\n"
        "  <- -+target(X, Y); move(north, [1, 2, f(Z)|Rest]); .print(\"at \", X); !go(X + 1, Y).\n",
        i, i * 7);
  }
  const auto source = std::make_shared<const Source>("large.asl", text);
  for (auto _ : state) {
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(load_agent(source, {}, diagnostics));
    if (diagnostics.has_errors()) state.SkipWithError("the text has errors");
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(Parse)->Unit(benchmark::kMillisecond);

void Unify(benchmark::State& state) {
  test::Terms terms;
  const Value a = terms.term("f(X, [1, 2, Y|T], g(\"text\", Z), p(q))");
  const Value b = terms.term("f(1, [1, 2, 3, 4, 5], g(\"text\", h(W)), p(q))");
  for (auto _ : state) {
    const std::size_t mark = terms.unifier().mark();
    benchmark::DoNotOptimize(terms.unifier().unify(a, b));
    terms.unifier().undo(mark);
  }
  count_items(state, 1);
}
BENCHMARK(Unify);

// One belief is added to many others, and removed.
void AddAndRemoveBelief(benchmark::State& state) {
  test::Terms terms;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const Value arg = Value::number(static_cast<double>(i));
    (void)terms.beliefs.add(
        terms.heap.structure(terms.symbols.predicate("b", 1), std::span(&arg, 1), source_self()));
  }
  const Value belief = terms.term("b(-1)[source(self)]");
  for (auto _ : state) {
    (void)terms.beliefs.add(belief);
    (void)terms.beliefs.remove(belief, terms.unifier());
    terms.beliefs.compact();
  }
  count_items(state, 1);
}
BENCHMARK(AddAndRemoveBelief)->RangeMultiplier(10)->Range(100, 1'000'000);

std::shared_ptr<const Program> compiled(const std::string& text, SymbolTable& symbols) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("bench.asl", text);
  return compile(load_agent(source, {}, diagnostics), symbols, diagnostics);
}

void Cycle(benchmark::State& state) {
  const auto symbols = std::make_shared<SymbolTable>();
  const auto program = compiled("!loop. +!loop <- !loop.", *symbols);
  Mas mas(symbols, {.max_cycles_per_tick = UINT64_MAX}, nullptr);
  mas.add_agent({.name = "agent", .program = program, .parameters = {}});
  for (auto _ : state) mas.stride();
  state.SetItemsProcessed(static_cast<std::int64_t>(mas.outcome().cycles));
}
BENCHMARK(Cycle);

// An agent perceives a thousand things, of which some change in each tick.
class Sights final : public Environment {
 public:
  static constexpr int kCount = 1000;

  Sights(SymbolTable& symbols, int changing)
      : sight_(symbols.predicate("sight", 2)), changing_(changing) {}

  void perceive(AgentId /*agent*/, Percepts& percepts) const override {
    for (int i = 0; i < kCount; ++i) {
      const double seen = i < changing_ ? ticks_ : 0;
      percepts.add(sight_, {Value::number(i), Value::number(seen)});
    }
  }
  void execute(std::span<const ActionRequest> /*actions*/,
               std::span<ActionResult> /*results*/) override {}
  void advance() override { ++ticks_; }
  [[nodiscard]] bool finished() const override { return false; }
  [[nodiscard]] double tick_ms() const override { return 1; }

 private:
  Predicate sight_;
  int changing_;
  double ticks_ = 0;
};

void Percepts(benchmark::State& state) {
  const auto symbols = std::make_shared<SymbolTable>();
  const auto program = compiled("idle.", *symbols);
  Sights sights(*symbols, static_cast<int>(state.range(0)));
  Mas mas(symbols, {}, &sights);
  mas.add_agent({.name = "agent", .program = program, .parameters = {}});
  mas.step();
  for (auto _ : state) mas.step();
  count_items(state, Sights::kCount);
}
BENCHMARK(Percepts)->Arg(0)->Arg(10)->Arg(100)->Arg(1000);

}  // namespace
}  // namespace jaywalk

BENCHMARK_MAIN();
