// Programs at random, through the whole interpreter, under small limits. See README.md.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

#include "tests/helpers/generate.h"
#include "tests/helpers/run_agents.h"

// A sanitizer's finding is to end as a signal, so that report_crash can name the case.
// NOLINTBEGIN(bugprone-reserved-identifier): the names are the sanitizers'.
extern "C" const char* __asan_default_options() { return "abort_on_error=1"; }
extern "C" const char* __ubsan_default_options() { return "abort_on_error=1:print_stacktrace=1"; }
// NOLINTEND(bugprone-reserved-identifier)

namespace jaywalk::test {
namespace {

/// CPU seconds that one case may take under sanitizers: conditions of a hundred goals that run into
/// a limit in every cycle take most of them.
constexpr double kSlowSeconds = 150;

/// Processor time of this process in seconds: other work on the machine does not count.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Sends SIGPROF after `seconds` of processor time from now.
void set_alarm(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  (void)setitimer(ITIMER_PROF, &timer, nullptr);
}

std::vector<std::string> read_corpus() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(JAYWALK_SOURCE_DIR "/tests/fuzz/corpus")) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    std::ifstream stream(path);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return texts;
}

/// The program of a case: a function of its number and the corpus.
std::string program_of(std::uint64_t number, const std::vector<std::string>& corpus) {
  Choices choices(number);
  const std::size_t kind = choices.below(4);
  const std::string& seed = corpus[choices.below(corpus.size())];
  switch (kind) {
    case 0:
      return mutate(choices, seed, corpus[choices.below(corpus.size())]);
    case 1: {
      const std::string generated = random_program(choices);
      return mutate(choices, generated, seed);
    }
    default:
      return random_program(choices);
  }
}

void run(const std::string& program, std::uint64_t seed) {
  MasOptions options;
  options.seed = seed;
  options.max_cycles = 200;
  options.max_inferences = 20'000;
  options.max_agent_bytes = 2U << 20U;
  (void)run_agents({{"agent", program}, {"other", program}}, options);
}

// The number of the case in progress, for the handler of its crash.
volatile std::uint64_t current_case = 0;

extern "C" void report_crash(int signal) {
  char text[80];
  const int length = std::snprintf(text, sizeof text, "\nfuzz: signal %d in case %llu\n", signal,
                                   static_cast<unsigned long long>(current_case));
  (void)!write(2, text, static_cast<std::size_t>(length));
  _exit(1);
}

struct Options {
  double seconds = 10;
  std::uint64_t seed = 1;
  bool single = false;
  bool show = false;
};

bool read_options(int count, char** words, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    const bool has_value = i + 1 < count;
    if (word == "--show") {
      options.show = true;
    } else if (word == "--seconds" && has_value) {
      options.seconds = std::strtod(words[++i], nullptr);
    } else if (word == "--seed" && has_value) {
      options.seed = std::strtoull(words[++i], nullptr, 10) << 32U;
    } else if (word == "--case" && has_value) {
      options.single = true;
      options.seed = std::strtoull(words[++i], nullptr, 10);
    } else {
      return false;
    }
  }
  return true;
}

int campaign(const Options& options, const std::vector<std::string>& corpus) {
  const double start = cpu_seconds();
  std::uint64_t number = options.seed;
  double longest = 0;
  for (;; ++number) {
    const double before = cpu_seconds();
    if (before - start > options.seconds) break;
    current_case = number;
    set_alarm(2 * kSlowSeconds);
    run(program_of(number, corpus), number);
    const double took = cpu_seconds() - before;
    longest = std::max(longest, took);
    if (took > kSlowSeconds) {
      std::printf("fuzz: case %llu took %.1f s of CPU\n", static_cast<unsigned long long>(number),
                  took);
      return 1;
    }
  }
  std::printf("fuzz: %llu cases, the longest took %.2f s\n",
              static_cast<unsigned long long>(number - options.seed), longest);
  return 0;
}

}  // namespace
}  // namespace jaywalk::test

int main(int count, char** words) {
  using namespace jaywalk::test;
  Options options;
  if (!read_options(count, words, options)) {
    std::fprintf(stderr, "usage: jaywalk_fuzz [--seconds N] [--seed N] [--case N [--show]]\n");
    return 2;
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGPROF}) std::signal(signal, report_crash);
  const std::vector<std::string> corpus = read_corpus();
  if (corpus.empty()) {
    std::fprintf(stderr, "fuzz: the corpus is empty\n");
    return 2;
  }
  if (!options.single) return campaign(options, corpus);
  const std::string program = program_of(options.seed, corpus);
  if (options.show) {
    std::printf("%s", program.c_str());
  } else {
    current_case = options.seed;
    run(program, options.seed);
    std::printf("fuzz: case %llu ended well\n", static_cast<unsigned long long>(options.seed));
  }
  return 0;
}
