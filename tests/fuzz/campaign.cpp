// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/campaign.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/fuzz/run_case.h"

// A sanitizer ends the process for what it finds, and holds the memory limit: an address space of
// terabytes cannot be limited by the system.
// NOLINTBEGIN(bugprone-reserved-identifier): the names are the sanitizers'.
extern "C" [[gnu::visibility("default")]] const char* __asan_default_options() {
  return "abort_on_error=1:allocator_may_return_null=1:max_allocation_size_mb=2048:"
         "hard_rss_limit_mb=3072";
}
extern "C" [[gnu::visibility("default")]] const char* __ubsan_default_options() {
  return "halt_on_error=1:abort_on_error=1:print_stacktrace=1";
}
// NOLINTEND(bugprone-reserved-identifier)

namespace jaywalk::fuzz {
namespace {

/// The cases of one process before another one replaces it, so that memory kept by libraries does
/// not count as the last case's.
constexpr std::uint64_t kCasesOfProcess = 500;
/// The reproducers after which a campaign ends.
constexpr int kMostFindings = 20;
/// How many smaller inputs are tried, and the largest file that is made smaller.
constexpr int kTriesToShrink = 400;
constexpr std::size_t kLargestToShrink = 1U << 16U;
/// The exit code of a process whose case ended in a way that run_case() complains about.
constexpr int kComplaint = 99;

/// The data shared by the process that runs cases and the one that watches it.
struct Progress {
  std::uint64_t number = 0;
  std::uint64_t slowest = 0;
  double spent_s = 0;
  double longest_s = 0;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double spent_by(int who) {
  rusage usage{};
  (void)getrusage(who, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

/// Processor time of this process and those it started.
double cpu_seconds() { return spent_by(RUSAGE_SELF) + spent_by(RUSAGE_CHILDREN); }

void set_timer(int which, int seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  (void)setitimer(static_cast<__itimer_which_t>(which), &timer, nullptr);
}

/// From now on the process ends by a signal if a case takes too long.
void limit_time() {
  set_timer(ITIMER_PROF, kCaseSeconds);
  set_timer(ITIMER_REAL, kCaseClockSeconds);
}

void limit_memory() {
#ifndef __SANITIZE_ADDRESS__
#ifndef __SANITIZE_THREAD__
  const rlimit limit{kCaseMegabytes << 20U, kCaseMegabytes << 20U};
  (void)setrlimit(RLIMIT_AS, &limit);
#endif
#endif
  const rlimit no_core{0, 0};
  (void)setrlimit(RLIMIT_CORE, &no_core);
}

/// A folder in memory if the user may have one: stores are written with care for the disk.
std::string make_scratch() {
  for (const std::string& place :
       {std::string("/dev/shm"), std::filesystem::temp_directory_path().string()}) {
    std::string folder = place + "/jaywalk-fuzz-XXXXXX";
    if (mkdtemp(folder.data()) != nullptr) return folder;
  }
  std::fprintf(stderr, "fuzz: no folder can be made for the cases: %s\n", std::strerror(errno));
  std::exit(2);
}

/// Runs one target's cases in child processes.
class Campaign {
 public:
  Campaign(const Target& target, const CampaignOptions& options)
      : target_(target), options_(options), scratch_(make_scratch()) {
    void* const memory =
        mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    progress_ = new (memory) Progress;
    // Targets keep what they begin with there.
    (void)setenv("JAYWALK_FUZZ_SCRATCH", scratch_.c_str(), 1);
    (void)setenv("HOME", scratch_.c_str(), 1);
    (void)setenv("XDG_STATE_HOME", scratch_.c_str(), 1);
    std::filesystem::create_directory(case_folder());
  }
  ~Campaign() {
    (void)munmap(progress_, sizeof(Progress));
    std::error_code ignored;
    std::filesystem::remove_all(scratch_, ignored);
  }
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;

  int run() {
    int findings = 0;
    std::uint64_t next = options_.first;
    while (!is_done(next) && findings < kMostFindings) {
      const std::string harm = watch([&] { run_cases(next); });
      next = progress_->number + 1;
      if (harm.empty()) continue;
      ++findings;
      report(progress_->number, harm);
    }
    std::printf("fuzz: %-14s %llu cases in %.1f s, the longest, %llu, took %.2f s\n",
                target_.name.data(), static_cast<unsigned long long>(next - options_.first),
                progress_->spent_s, static_cast<unsigned long long>(progress_->slowest),
                progress_->longest_s);
    return findings;
  }

 private:
  [[nodiscard]] std::string case_folder() const { return scratch_ + "/case"; }
  [[nodiscard]] std::string errors() const { return scratch_ + "/stderr"; }

  [[nodiscard]] bool is_done(std::uint64_t next) const {
    if (options_.cases > 0) return next >= options_.first + options_.cases;
    return progress_->spent_s > options_.seconds;
  }

  /// In the child: cases from that number on, until it is another process's turn.
  void run_cases(std::uint64_t first) {
    for (std::uint64_t number = first; number < first + kCasesOfProcess; ++number) {
      if (number > first && is_done(number)) break;
      progress_->number = number;
      const double before = cpu_seconds();
      const std::string complaint = run_one(make_case(target_, number));
      const double took = cpu_seconds() - before;
      progress_->spent_s += took;
      if (took > progress_->longest_s) {
        progress_->longest_s = took;
        progress_->slowest = number;
      }
      if (!complaint.empty()) complain(complaint);
    }
  }

  std::string run_one(const Case& made) {
    if (ftruncate(STDERR_FILENO, 0) != 0) {
      // The previous case's output stays: it only makes the report longer.
    }
    limit_time();
    return run_case(made, case_folder());
  }

  [[noreturn]] static void complain(const std::string& complaint) {
    std::fprintf(stderr, "\n%s\n", complaint.c_str());
    std::fflush(stderr);
    std::_Exit(kComplaint);
  }

  /// The problem of `work`, run in a process of its own; empty if it ended well.
  template <class Work>
  std::string watch(const Work& work) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      become_worker();
      work();
      std::exit(0);  // not _Exit: the leak sanitizer looks
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    return harm_of(status);
  }

  void become_worker() {
    // NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): the system has no other interface
    const int none = ::open("/dev/null", O_WRONLY);
    const int errors_file = ::open(errors().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
    // NOLINTEND(cppcoreguidelines-pro-type-vararg)
    (void)::dup2(none, STDOUT_FILENO);
    (void)::dup2(errors_file, STDERR_FILENO);
    (void)::close(none);
    (void)::close(errors_file);
    limit_memory();
  }

  std::string harm_of(int status) const {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    if (WIFEXITED(status) && WEXITSTATUS(status) == kComplaint) return last_error();
    if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
    switch (WTERMSIG(status)) {
      case SIGPROF:
        return "more than " + std::to_string(kCaseSeconds) + " s of processor time";
      case SIGALRM:
        return "no end after " + std::to_string(kCaseClockSeconds) + " s";
      default:
        return "signal " + std::to_string(WTERMSIG(status));
    }
  }

  [[nodiscard]] std::string last_error() const {
    std::FILE* const file = std::fopen(errors().c_str(), "r");
    if (file == nullptr) return "unknown";
    std::string last;
    std::array<char, 4096> line{};
    while (std::fgets(line.data(), line.size(), file) != nullptr) last = line.data();
    (void)std::fclose(file);
    if (last.ends_with('\n')) last.pop_back();
    return last;
  }

  void report(std::uint64_t number, const std::string& harm) {
    const std::string name = std::string(target_.name) + "-" + std::to_string(number);
    const std::string folder = options_.findings + "/" + name;
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    std::filesystem::copy_file(errors(), folder + "/stderr",
                               std::filesystem::copy_options::overwrite_existing, ignored);
    // In a process of its own: whoever forks must not have threads or open stores.
    (void)watch([&] { write_case(make_case(target_, number), folder + "/whole"); });
    if (harm.starts_with("signal") || harm.starts_with("internal") || harm.starts_with("exit")) {
      (void)watch([&] { shrink(make_case(target_, number), harm, folder + "/small"); });
    }
    std::printf("fuzz: %s: %s; see %s\n", name.c_str(), harm.c_str(), folder.c_str());
  }

  /// In a child: drops parts of the files and the input as long as the same harm is done.
  void shrink(Case made, const std::string& harm, const std::string& folder) {
    int tries = kTriesToShrink;
    const auto still_does = [&](const Case& smaller) {
      --tries;
      return watch([&] {
               const std::string complaint = run_one(smaller);
               if (!complaint.empty()) complain(complaint);
             }) == harm;
    };
    std::vector<std::string*> texts{&made.input};
    for (auto& file : made.files) texts.push_back(&file.second);
    for (std::string* text : texts) {
      for (std::size_t length = text->size() / 2; length > 0 && tries > 0; length /= 2) {
        if (text->size() > kLargestToShrink) break;
        for (std::size_t at = 0; at + length <= text->size() && tries > 0;) {
          const std::string before = *text;
          text->erase(at, length);
          if (still_does(made)) continue;
          *text = before;
          at += length;
        }
      }
    }
    write_case(made, folder);
  }

  const Target& target_;
  const CampaignOptions& options_;
  std::string scratch_;
  Progress* progress_ = nullptr;
};

}  // namespace

int run_campaign(const Target& target, const CampaignOptions& options) {
  return Campaign(target, options).run();
}

Case make_case(const Target& target, std::uint64_t number) {
  Choices choices(number);
  return target.make(choices);
}

}  // namespace jaywalk::fuzz
