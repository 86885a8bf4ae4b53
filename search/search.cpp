// SPDX-License-Identifier: Apache-2.0
#include "search/search.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "env/process/guarded_child.h"
#include "interpreter/support/start_threads.h"

namespace jaywalk::search {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kProgressInterval{200};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The state shared by the threads.
class Shared {
 public:
  Shared(const SearchPlan& search_plan, TestLog* test_log, const SearchObserver& observer)
      : plan(search_plan), log(test_log), observer_(observer), spent_(search_plan.searches()) {}

  const SearchPlan& plan;
  TestLog* log;
  std::atomic<bool> stop = false;
  /// A test that was under way may have been given up.
  [[nodiscard]] bool stopping() const { return stop || end_requested; }
  std::atomic<std::size_t> next = 0;

  void note(std::size_t search, const SearchRun& run, const TestRow& row, double spent) {
    const std::scoped_lock lock(mutex_);
    ++progress_.tests;
    progress_.failures += row.test.failed ? 1 : 0;
    progress_.best_fitness = std::max(progress_.best_fitness, row.test.fitness);
    spent_[search] = spent;
    if (row.test.outcome.error.empty()) return;
    ++progress_.errors;
    if (!observer_.error) return;
    observer_.error(run.generator, run.repetition, run.tests.size() - 1, row.test.outcome.error);
  }

  void finish(std::size_t search, SearchRun& run) const {
    if (observer_.finished) observer_.finished(search, run);
  }

  void trouble(std::string subject, std::string message, std::string hint = {}) {
    const std::scoped_lock lock(mutex_);
    trouble_.error(std::move(subject), std::move(message), std::move(hint));
    stop = true;
  }

  void end_thread() {
    const std::scoped_lock lock(mutex_);
    ++ended_;
    changed_.notify_all();
  }

  /// Shows progress until all threads have ended.
  void watch(unsigned threads) {
    std::unique_lock lock(mutex_);
    while (true) {
      const bool done =
          changed_.wait_for(lock, kProgressInterval, [&] { return ended_ == threads; });
      SearchProgress now = progress_;
      for (const double spent : spent_) now.spent += spent / static_cast<double>(spent_.size());
      // The observer may take its time, and may ask what locks: never under the mutex.
      lock.unlock();
      if (observer_.progress && observer_.progress(now) == Continue::no) stop = true;
      lock.lock();
      if (done) return;
    }
  }

  [[nodiscard]] Diagnostics& diagnostics() { return trouble_; }

 private:
  const SearchObserver& observer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  SearchProgress progress_;
  std::vector<double> spent_;
  Diagnostics trouble_;
  unsigned ended_ = 0;
};

class Search {
 public:
  Search(Shared& shared, std::size_t index, SearchRun& run)
      : shared_(shared),
        plan_(shared.plan),
        index_(index),
        run_(run),
        spec_(plan_.generators[index / plan_.repetitions]),
        model_(plan_.model_of(spec_)),
        sut_(model_.make()),
        generator_(spec_.kind->make({.space = model_.space(),
                                     .measures = model_.measures(),
                                     .fitness = plan_.fitness,
                                     .seed = run.seed,
                                     .values = spec_.values})) {
    sut_->stop_when([&shared] { return shared.stopping(); });
  }

  void go() {
    while (!over() && !generator_->exhausted()) {
      if (shared_.stopping()) return;
      const auto start = Clock::now();
      Asking asking(model_.space(), spent());
      TestInput input = generator_->ask(asking);
      // Learning from the test before is part of what this test cost the generator.
      const double generation = seconds_since(start) + telling_s_;
      if (const Validity validity = model_.space().check(input); !validity.valid()) {
        shared_.trouble(subject(),
                        fmt::format("none of {} candidates is a valid test; the last one: {}",
                                    asking.candidates(), validity.message),
                        "the keys of 'sut' decide which tests there are and which are valid");
        return;
      }
      TestRow row{.candidates = asking.candidates(),
                  .invalid = asking.invalid(),
                  .generation_s = generation};
      row.test.input = std::move(input);
      if (!execute(row)) return;
      const Budget& budget = plan_.budget;
      const bool refused = !row.test.outcome.refused.empty();
      const double cost =
          refused ? 0
                  : row.test.outcome.simulated_s + budget.overhead_s + plan_.generation_s(spec_);
      // A test that would end after the budget does not count: it was still running then.
      if (budget.virtual_s > 0 && run_.spent_s + cost > budget.virtual_s) break;
      if (!keep(std::move(row), cost)) return;
      refused_in_a_row_ = refused ? refused_in_a_row_ + 1 : 0;
      if (refused ? refuses_all() : takes_no_time(cost)) return;
    }
    run_.complete = true;
    shared_.finish(index_, run_);
  }

 private:
  [[nodiscard]] std::string subject() const {
    return fmt::format("{}, repetition {}", run_.generator, run_.repetition);
  }

  /// Whether the SUT has refused very many tests in a row.
  bool refuses_all() {
    const int most = refused_ == run_.tests.size() ? kFirstDraws : kMostDraws;
    if (refused_in_a_row_ < most) return false;
    shared_.trouble(subject(),
                    fmt::format("{} tests in a row are invalid; the last one: {}", most,
                                run_.tests.back().test.outcome.refused),
                    "the program answers so; see whether its inputs can have other ranges");
    return true;
  }

  /// Whether nothing but virtual time ends the search and very many tests in a row took none.
  bool takes_no_time(double cost) {
    constexpr int kPatience = 1000;
    timeless_ = cost > 0 ? 0 : timeless_ + 1;
    if (plan_.budget.tests > 0 || timeless_ < kPatience) return false;
    shared_.trouble(subject(),
                    fmt::format("{} tests in a row took no simulated time, so that the budget's "
                                "'virtual_s' never ends",
                                kPatience),
                    "give 'tests' or an 'overhead_s' above 0");
    return true;
  }

  [[nodiscard]] bool over() const { return spent() >= 1; }

  [[nodiscard]] double spent() const {
    const Budget& budget = plan_.budget;
    double share = 0;
    const auto used = [&share](double part, double whole) {
      if (whole > 0) share = std::max(share, part / whole);
    };
    // Whichever limit is nearest ends the search; one of 0 is none.
    used(run_.spent_s, budget.virtual_s);
    used(static_cast<double>(run_.tests.size() - refused_), static_cast<double>(budget.tests));
    used(static_cast<double>(failures_), static_cast<double>(budget.failures));
    return std::min(share, 1.0);
  }

  /// Executes the test unless its outcome is known; false if the search cannot go on.
  bool execute(TestRow& row) {
    const std::size_t number = run_.tests.size();
    if (shared_.log != nullptr && number < shared_.log->finished(index_).size()) {
      const TestRow& known = shared_.log->finished(index_)[number];
      if (known.test.input != row.test.input) {
        shared_.trouble(subject(), fmt::format("test {} is not the one in the store, which another "
                                               "version of the program wrote",
                                               number));
        return false;
      }
      row = known;
      // The SUT may measure a test by those before it, so that it has to see the known ones, too.
      sut_->remember(row.test.outcome);
      return true;
    }
    const auto start = Clock::now();
    row.test.outcome = sut_->run(row.test.input, number);
    if (shared_.stopping()) return false;  // with --resume it is run again
    row.execution_s = seconds_since(start);
    if (!row.test.outcome.refused.empty()) {
      row.candidates = std::max<std::uint64_t>(row.candidates, 1);
      ++row.invalid;
    }
    row.test.fitness = plan_.fitness.of(row.test.outcome);
    row.test.failed = row.test.outcome.executed() && plan_.fitness.fails(row.test.fitness);
    return true;
  }

  bool keep(TestRow row, double cost) {
    const std::size_t number = run_.tests.size();
    const bool known = shared_.log != nullptr && number < shared_.log->finished(index_).size();
    if (shared_.log != nullptr && !known) {
      if (shared_.log->add(index_, number, row) == Continue::no) {
        shared_.stop = true;
        return false;
      }
    }
    // First the store, then the generator: a test that could not be kept must not be learned from.
    run_.spent_s += cost;
    refused_ += row.test.outcome.refused.empty() ? 0 : 1;
    failures_ += row.test.failed ? 1 : 0;
    run_.tests.push_back(std::move(row));
    shared_.note(index_, run_, run_.tests.back(), spent());
    const auto start = Clock::now();
    generator_->tell(run_.tests.back().test, spent());
    telling_s_ = seconds_since(start);
    return true;
  }

  Shared& shared_;
  const SearchPlan& plan_;
  std::size_t index_;
  SearchRun& run_;
  const GeneratorSpec& spec_;
  const SutModel& model_;
  std::unique_ptr<Sut> sut_;
  std::unique_ptr<Generator> generator_;
  std::uint64_t failures_ = 0;
  int timeless_ = 0;  // tests in a row that took no virtual time
  std::size_t refused_ = 0;
  int refused_in_a_row_ = 0;
  double telling_s_ = 0;
};

void work(Shared& shared, std::vector<SearchRun>& runs) {
  while (!shared.stopping()) {
    const std::size_t index = shared.next++;
    if (index >= runs.size()) break;
    try {
      Search(shared, index, runs[index]).go();
    } catch (const std::exception& error) {
      shared.trouble(
          fmt::format("{}, repetition {}", runs[index].generator, runs[index].repetition),
          error.what());
    }
  }
  shared.end_thread();
}

}  // namespace

SearchResults run_searches(const SearchPlan& plan, TestLog* log, const SearchObserver& observer) {
  SearchResults results;
  for (const GeneratorSpec& generator : plan.generators) {
    for (std::uint32_t repetition = 0; repetition < plan.repetitions; ++repetition) {
      results.runs.push_back({.generator = generator.name,
                              .repetition = repetition,
                              // By the generator's name, so that a search does not depend on which
                              // others are in the plan.
                              .seed = mix(mix_name(plan.seed, generator.seed_name()), repetition)});
    }
  }
  Shared shared(plan, log, observer);
  {
    std::vector<std::jthread> threads;
    const std::size_t count =
        start_threads(threads, plan.threads, [&] { work(shared, results.runs); });
    shared.watch(static_cast<unsigned>(count));
  }
  results.trouble = std::move(shared.diagnostics());
  results.complete = std::ranges::all_of(results.runs, &SearchRun::complete);
  return results;
}

}  // namespace jaywalk::search
