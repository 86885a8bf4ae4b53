// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "experiment/results/store/row_writer.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/store/store_file.h"
#include "experiment/results/stored_rows.h"
#include "experiment/results/writer.h"

namespace jaywalk {

class AssessmentWriter::Impl {
 public:
  Impl(std::string path, DescribedStore store)
      : path_(std::move(path)),
        database_(std::move(store.database)),
        description_(std::move(store.description)),
        rows_(*database_, description_),
        remove_(*database_, "DELETE FROM assessments WHERE id >= ? AND id < ?") {
    start_log(*database_);
    database_->execute("BEGIN");
  }

  void note_judging(std::span<const SourcePtr> files, bool metrics) {
    const ExperimentDescription before = description_;
    add_judging(description_, files, metrics);
    write_judging(*database_, before, description_);
  }

  void replace(std::int64_t test_id, const std::vector<AssessmentRow>& assessments) {
    std::vector<AssessmentRow> all = read_assessments(*database_, test_id);
    std::erase_if(all, [&](const AssessmentRow& old) {
      return std::ranges::any_of(assessments,
                                 [&](const AssessmentRow& each) { return each.id == old.id; });
    });
    all.insert(all.end(), assessments.begin(), assessments.end());
    remove_.run(row_id(test_id, 0), row_id(test_id + 1, 0));
    rows_.write(test_id, all);
  }

  std::optional<std::string> finish() {
    database_->execute("COMMIT");
    return finish_log(*database_, path_);
  }

 private:
  std::string path_;
  std::unique_ptr<Database> database_;
  ExperimentDescription description_;
  RowWriter rows_;
  Statement remove_;
};

AssessmentWriter::AssessmentWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AssessmentWriter::~AssessmentWriter() = default;

Result<std::unique_ptr<AssessmentWriter>> AssessmentWriter::open(const std::string& path) {
  auto store = described(open_to_write(path, results_store()), path);
  if (!store) return std::move(store.diagnostics());
  auto impl = std::make_unique<Impl>(path, std::move(store).value());
  return std::unique_ptr<AssessmentWriter>(new AssessmentWriter(std::move(impl)));
}

void AssessmentWriter::note_judging(std::span<const SourcePtr> files, bool metrics) {
  impl_->note_judging(files, metrics);
}

void AssessmentWriter::replace(std::int64_t test_id,
                               const std::vector<AssessmentRow>& assessments) {
  impl_->replace(test_id, assessments);
}

std::optional<std::string> AssessmentWriter::finish() { return impl_->finish(); }

}  // namespace jaywalk
