// Searches: a custom system and a custom generator beside one of Jaywalk's; and a search from a
// file.
#include <cmath>
#include <iostream>

#include <jaywalk/search.h>

namespace js = jaywalk::search;

namespace {

// The system: a brake that is weakest near (0.5, -0.25). It measures the distance at which it
// stops.
class Brake : public js::SystemExecutor {
 public:
  js::SystemOutcome run(std::span<const double> input, std::size_t) override {
    const double from_worst = std::hypot(input[0] - 0.5, input[1] + 0.25);
    return {.simulated_s = 5, .measures = {from_worst}};
  }
};

// The generator: halves its step towards the best input so far.
class Halving : public js::InputGenerator {
 public:
  std::vector<double> ask(const std::function<bool(std::span<const double>)>& is_valid,
                          double) override {
    const double angle = 2.4 * ++asked_;
    std::vector<double> next{best_[0] + step_ * std::cos(angle),
                             best_[1] + step_ * std::sin(angle)};
    return is_valid(next) ? next : best_;
  }
  void tell(std::span<const double> input, double fitness, bool) override {
    if (fitness > fitness_) {
      fitness_ = fitness;
      best_.assign(input.begin(), input.end());
    } else {
      step_ *= 0.95;
    }
  }

 private:
  std::vector<double> best_{0, 0};
  double fitness_ = -1;
  double step_ = 0.8;
  int asked_ = 0;
};

}  // namespace

int main() {
  const auto brake = js::RunnableSearch::make(
      {.name = "brake",
       .system = {.name = "brake",
                  .dimension = 2,
                  .measures = {"distance"},
                  .make_executor = [] { return std::make_unique<Brake>(); }},
       .measure = "distance",
       .harmless = 1,
       .worst = 0,
       .generators = {"random"},
       .custom_generators = {{.name = "halving",
                              .make = [](std::size_t,
                                         std::uint64_t) { return std::make_unique<Halving>(); }}},
       .tests = 60});
  if (!brake) {
    std::cerr << brake.diagnostics().render();
    return 2;
  }
  const auto found = brake.value().run({.seed = 1, .threads = 2});
  if (!found) return 1;
  for (const js::SearchRunReport& run : found.value().runs) {
    std::cout << run.generator << ": " << run.failures() << " of " << run.tests.size()
              << " tests failed\n";
  }

  const auto roads = js::RunnableSearch::read(
      JAYWALK_DATA_DIR "/scenarios/search/lane-keeping.yaml",
      {.sets = {"budget.tests=20"}, .generators = {"random"}, .data_folder = JAYWALK_DATA_DIR});
  if (!roads) {
    std::cerr << roads.diagnostics().render();
    return 2;
  }
  const auto report = roads.value().run({.repetitions = 1});
  if (!report) return 1;
  const js::SearchRunReport& run = report.value().runs.front();
  std::cout << roads.value().measures().front() << " of " << run.tests.size() << " roads of "
            << run.tests.front().points.size() / 2 << " points or so\n";
}
