// SPDX-License-Identifier: Apache-2.0
// How fast the results store takes what is observed: tests of 10 pedestrians and 12 ticks, all kept
// at every tick, from as many threads as ask for it. The time is the process' CPU time, from the
// first test to the closed file with its index; what a machine is busy with besides does not count.
//
//   jaywalk_bench_store [TESTS]

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "experiment/results/reader.h"
#include "experiment/results/writer.h"

namespace jaywalk {
namespace {

constexpr std::uint32_t kPedestrians = 10;
constexpr std::size_t kTicks = 12;
constexpr int kSamples = 3;

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

Recording recording() {
  std::vector<Actor> actors{{"av", ActorKind::vehicle, 4.5, 3}};
  for (std::uint32_t i = 1; i <= kPedestrians; ++i) {
    actors.push_back({fmt::format("p{}", i), ActorKind::pedestrian, 0.5, 0.5});
  }
  Recording result(1, actors);
  for (std::size_t tick = 0; tick < kTicks; ++tick) {
    std::vector<ActorState> scene;
    for (std::size_t i = 0; i < actors.size(); ++i) {
      const double at = static_cast<double>(tick) * 1.5;
      scene.push_back({at + 0.1 * static_cast<double>(i), 40 + at / 3, 1.5, 0});
    }
    result.add(scene);
  }
  result.add({.tick = 5, .actor = 1, .kind = "precondition", .text = ""});
  return result;
}

/// CPU seconds for a store of `tests` tests; 0 after saying why there is none.
double write(const std::string& path, std::uint64_t tests) {
  const ExperimentDescription description{.scenario = "bench.yaml",
                                          .behaviours = {{.name = "bench"}},
                                          .agents = {kPedestrians},
                                          .tests = tests,
                                          .level = StoreLevel::all,
                                          .version = "bench"};
  const Recording seen = recording();
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  const double begin = cpu_s();
  auto store = ResultsWriter::create(path, description);
  if (!store) {
    fmt::print(stderr, "{}", store.diagnostics().render());
    return 0;
  }
  for (std::uint64_t test = 0; test < tests; ++test) {
    TestRecord record;
    record.test = {.behaviour = 0, .agents = kPedestrians, .number = test};
    record.result = {.succeeded = true, .ticks = kTicks - 1};
    record.outcome.ticks = kTicks - 1;
    record.outcome.precondition_ticks = kTicks - 1;
    record.outcome.ended_by = "precondition";
    record.recording = seen;
    record.scores.resize(kPedestrians);
    store.value()->add(std::move(record));
  }
  if (const auto failure = store.value()->finish()) {
    fmt::print(stderr, "{}\n", *failure);
    return 0;
  }
  return cpu_s() - begin;
}

int main_of(std::uint64_t tests) {
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("jaywalk-bench-{}.gpkg", ::getpid()))
          .string();
  std::vector<double> samples;
  for (int i = 0; i < kSamples; ++i) samples.push_back(write(path, tests));
  const auto bytes = std::filesystem::file_size(path);
  const auto store = ResultsReader::open(path);
  const bool complete = store.ok() && store.value()->complete();
  std::filesystem::remove(path);
  const double best = *std::ranges::min_element(samples);
  if (best == 0 || !complete) return EXIT_FAILURE;
  const auto rows = static_cast<double>(tests * kTicks * (kPedestrians + 1));
  fmt::print("{:.0f} observations in {:.2f} s of CPU time: {:.0f} a second, {:.0f} bytes each\n",
             rows, best, rows / best, static_cast<double>(bytes) / rows);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace jaywalk

int main(int argc, char** argv) {
  constexpr std::uint64_t kTests = 8000;
  return jaywalk::main_of(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : kTests);
}
