// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/writer.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiment/results/reader.h"
#include "experiment/results/store/row_writer.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/store/store_file.h"

namespace jaywalk {
namespace {

/// How many states of actors may wait to be written: those of about a thousand small tests.
constexpr std::size_t kMaxWaiting = 30'000;
/// A transaction for each test would be ten times as slow; what came in within this time shares
/// one.
constexpr auto kGather = std::chrono::milliseconds(30);

std::size_t weight(const TestRecord& record) {
  constexpr std::size_t kEmptyRecord = 10;
  return kEmptyRecord + record.recording.scenes() * record.recording.actors().size();
}

/// Why the plan is too large to number its tests.
std::optional<std::string> excess(const ExperimentDescription& description) {
  const std::uint64_t cells = jaywalk::cells(description);
  if (cells == 0 || description.tests == 0) return "there are no tests to store";
  if (cells <= static_cast<std::uint64_t>(kMaxTestId) / description.tests) return std::nullopt;
  return fmt::format("more than {} tests cannot be stored", kMaxTestId);
}

/// The errors that prevent this experiment from continuing the store.
std::optional<Diagnostics> mismatch(const std::string& path, const ExperimentDescription& stored,
                                    const ExperimentDescription& wanted) {
  const auto refuse = [&](std::string why) {
    return store_error(path, std::move(why), "choose another file, or ask for the same experiment");
  };
  if (const std::string why = difference(stored, wanted); !why.empty()) {
    return refuse(fmt::format("the store holds another experiment: {}", why));
  }
  if (stored.level != wanted.level) {
    return refuse(
        fmt::format("the store's level is {}, not {}", name(stored.level), name(wanted.level)));
  }
  if (stored.shard != wanted.shard) {
    return refuse(fmt::format("the store holds shard {}/{}, not {}/{}", stored.shard.index,
                              stored.shard.count, wanted.shard.index, wanted.shard.count));
  }
  return std::nullopt;
}

/// The experiment is the store's, but for more tests.
bool is_extension(const ExperimentDescription& stored, const ExperimentDescription& wanted) {
  ExperimentDescription extended = stored;
  extended.tests = wanted.tests;
  // Compared as if it had as many tests: nothing else may differ.
  return wanted.tests > stored.tests && !mismatch({}, extended, wanted);
}

/// Adds `shift` to the ids of the tests from `first` to `last`, and to those of the rows that
/// belong to them. They become negative until all are moved, so that none meets another.
void move_rows(Database& database, std::string_view table, std::int64_t first, std::int64_t last,
               std::int64_t shift) {
  if (table == "tests") {
    database.execute(fmt::format("UPDATE tests SET id = -(id + {}) WHERE id BETWEEN {} AND {}",
                                 shift, first, last));
    return;
  }
  database.execute(fmt::format(
      "UPDATE {} SET id = -(id + {}), test_id = test_id + {} WHERE id >= {} AND id < {}", table,
      row_id(shift, 0), shift, row_id(first, 0), row_id(last + 1, 0)));
}

/// Makes a store of `before` one of an experiment with `tests` tests of each behaviour and number
/// of agents, in one transaction; the new ones are still missing. Ids follow from the plan, so that
/// those of most tests change. REQUIRES: opened to be written, and `tests` > before.tests.
void extend_store(Database& database, const ExperimentDescription& before, std::uint64_t tests) {
  const std::uint64_t cells = jaywalk::cells(before);
  database.execute("BEGIN");
  // It is no longer complete; the index comes again when it is.
  database.execute("DROP INDEX IF EXISTS observations_of_test");
  for (const std::string_view table : kTablesOfTests) {
    for (std::uint64_t cell = 1; cell < cells; ++cell) {
      const auto first = static_cast<std::int64_t>(cell * before.tests + 1);
      const auto last = static_cast<std::int64_t>((cell + 1) * before.tests);
      const auto shift = static_cast<std::int64_t>(cell * (tests - before.tests));
      move_rows(database, table, first, last, shift);
    }
    database.execute(fmt::format("UPDATE {} SET id = -id WHERE id < 0", table));
  }
  database.execute(fmt::format("UPDATE experiment SET tests = {}", tests));
  database.execute("COMMIT");
}

/// In one transaction: a test is there whole, or it is missing and can be run.
void take_out_errored(Database& store) {
  store.execute("BEGIN");
  store.execute(
      "CREATE TEMP TABLE errored AS SELECT id FROM main.tests WHERE ended_by = 'errored'");
  for (const std::string_view table : kTablesOfTests) {
    // kTablesOfTests has `tests` among them; the other tables refer to it.
    const std::string_view key = table == "tests" ? "id" : "test_id";
    store.execute(
        fmt::format("DELETE FROM main.{} WHERE {} IN (SELECT id FROM errored)", table, key));
  }
  store.execute("DROP TABLE temp.errored");
  store.execute("COMMIT");
}

/// Which tests a store has.
struct StoredIds {
  std::vector<bool> has;  // by id
  std::uint64_t count = 0;
};

Result<StoredIds> read_ids(const std::string& path, DescribedStore& store) {
  StoredIds ids;
  Statement row(*store.database, "SELECT id FROM tests ORDER BY id");
  while (row.step()) {
    const std::int64_t id = row.number(0);
    if (!find_test(store.description, id)) {
      return store_error(path, fmt::format("the store is damaged: it has a test {}", id));
    }
    ids.has.resize(static_cast<std::size_t>(id) + 1);
    ids.has.back() = true;
    ++ids.count;
  }
  if (store.database->failure()) return store_error(path, trouble_with(*store.database));
  return ids;
}

}  // namespace

TestRecord make_test_record(const TestKey& test, const TestResult& result, const TestRun& run,
                            Recording recording) {
  TestRecord record{.test = test,
                    .result = result,
                    .outcome = outcome_of(run),
                    .recording = std::move(recording)};
  for (const AgentOutcome& outcome : run.outcome.agents) {
    record.scores.push_back(
        {.cost = outcome.cost, .reward = outcome.reward, .actions = outcome.actions});
  }
  record.drops = run.troubles.drops;
  return record;
}

class ResultsWriter::Impl {
 public:
  Impl(std::string path, std::unique_ptr<Database> database, ExperimentDescription description,
       StoredIds had)
      : path_(std::move(path)),
        database_(std::move(database)),
        description_(std::move(description)),
        had_(std::move(had)) {
    writer_ = std::jthread([this] { write_until_closed(); });
  }

  ~Impl() { close(); }

  [[nodiscard]] bool had(const TestKey& test) const {
    const auto id = static_cast<std::size_t>(test_id(description_, test));
    return id < had_.has.size() && had_.has[id];
  }
  [[nodiscard]] std::uint64_t had() const { return had_.count; }
  [[nodiscard]] const std::optional<std::string>& database_failure() const {
    return database_->failure();
  }

  void add(TestRecord record) {
    const std::size_t size = weight(record);
    std::unique_lock lock(mutex_);
    // A single record may be heavier than all that may wait: it is let in alone.
    taken_.wait(lock, [&] { return failure_ || weight_ == 0 || weight_ + size <= kMaxWaiting; });
    if (failure_) return;
    waiting_.push_back(std::move(record));
    weight_ += size;
    came_in_.notify_one();
  }

  [[nodiscard]] std::optional<std::string> failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
  }

  std::optional<std::string> close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      came_in_.notify_one();
    }
    if (writer_.joinable()) writer_.join();
    if (database_ && !failure_) finish_file();
    database_.reset();
    return failure_;
  }

 private:
  void write_until_closed() {
    RowWriter rows(*database_, description_);
    std::vector<TestRecord> records;
    while (take(records)) {
      database_->execute("BEGIN");
      for (const TestRecord& record : records) rows.write(record);
      database_->execute("COMMIT");
      written_ += records.size();
      records.clear();
      if (database_->failure()) {
        give_up(trouble_with(*database_));
        return;
      }
    }
  }

  /// All that is waiting; false once there is nothing more to come.
  bool take(std::vector<TestRecord>& records) {
    std::unique_lock lock(mutex_);
    came_in_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    // More may come in while this waits, which then share the transaction.
    came_in_.wait_for(lock, kGather, [&] { return closed_ || weight_ > kMaxWaiting / 2; });
    records.swap(waiting_);
    weight_ = 0;
    taken_.notify_all();
    return !records.empty();
  }

  void give_up(std::string why) {
    const std::lock_guard lock(mutex_);
    failure_ = std::move(why);
    taken_.notify_all();
  }

  void finish_file() {
    // A store with all tests may lack the last steps of finishing, if the process was killed then.
    if (written_ > 0 || !is_completed(*database_)) {
      note_extents(*database_, Placement(description_.anchor));
    }
    const std::uint64_t planned = cells(description_) * tests_in_shard(description_);
    if (had_.count + written_ == planned) complete_tables(*database_);
    if (const auto why = finish_log(*database_, path_)) give_up(*why);
  }

  std::string path_;
  std::unique_ptr<Database> database_;
  ExperimentDescription description_;
  StoredIds had_;
  std::uint64_t written_ = 0;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable came_in_;
  std::condition_variable taken_;
  std::vector<TestRecord> waiting_;
  std::size_t weight_ = 0;
  bool closed_ = false;
  std::optional<std::string> failure_;

  std::jthread writer_;
};

ResultsWriter::ResultsWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsWriter::~ResultsWriter() = default;

Result<std::unique_ptr<ResultsWriter>> ResultsWriter::create(
    const std::string& path, const ExperimentDescription& description) {
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    return store_error(path, "the file exists",
                       "--resume continues a store; otherwise choose another name");
  }
  return resume(path, description);
}

Result<std::unique_ptr<ResultsWriter>> ResultsWriter::resume(
    const std::string& path, const ExperimentDescription& description, ErroredTests errored) {
  if (const auto why = excess(description)) return store_error(path, *why);
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    const auto fill = [&](Database& database) {
      create_tables(database, Placement(description.anchor));
      write_description(database, description);
    };
    if (auto failure = create_store_file(path, fill)) return std::move(*failure);
  }
  auto store = described(open_to_write(path, results_store()), path);
  if (!store) return std::move(store.diagnostics());
  Database& database = *store.value().database;
  const ExperimentDescription stored = store.value().description;
  const bool extends = is_extension(stored, description);
  if (auto why = mismatch(path, stored, description); why && !extends) return std::move(*why);
  // Read before anything is changed, since a damaged store stays as it is.
  auto ids = read_ids(path, store.value());
  if (!ids) return std::move(ids.diagnostics());
  start_log(database);
  if (extends) extend_store(database, stored, description.tests);
  if (errored == ErroredTests::taken_out) take_out_errored(database);
  if (extends || errored == ErroredTests::taken_out) {
    store.value().description.tests = description.tests;
    ids = read_ids(path, store.value());
    if (!ids) return std::move(ids.diagnostics());
  }
  if (database.failure()) return store_error(path, trouble_with(database));
  auto impl = std::make_unique<Impl>(path, std::move(store.value().database), description,
                                     std::move(ids).value());
  return std::unique_ptr<ResultsWriter>(new ResultsWriter(std::move(impl)));
}

bool ResultsWriter::had(const TestKey& test) const { return impl_->had(test); }
std::uint64_t ResultsWriter::had() const { return impl_->had(); }
void ResultsWriter::add(TestRecord record) { impl_->add(std::move(record)); }
std::optional<std::string> ResultsWriter::failure() const { return impl_->failure(); }
std::optional<std::string> ResultsWriter::finish() { return impl_->close(); }

Result<std::unique_ptr<ResultsWriter>> open_store(const StoreOptions& options,
                                                  ExperimentDescription description) {
  description.shard = options.shard;
  description.level = options.level.value_or(StoreLevel::found);
  if (!options.resume) return ResultsWriter::create(options.path, description);
  std::error_code error;
  if (!options.level && std::filesystem::exists(options.path, error)) {
    const auto there = ResultsReader::open(options.path);
    if (!there) return there.diagnostics();
    description.level = there.value()->description().level;
  }
  return ResultsWriter::resume(options.path, description,
                               options.retry_errors ? ResultsWriter::ErroredTests::taken_out
                                                    : ResultsWriter::ErroredTests::kept);
}

Diagnostics unwritten_store(const std::string& path, std::string_view why) {
  Diagnostics diagnostics;
  diagnostics.error(
      std::string(), fmt::format("cannot write '{}': {}", path, why),
      "the tests written before are kept; the same command with --resume runs the others");
  return diagnostics;
}

}  // namespace jaywalk
