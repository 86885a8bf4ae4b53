#include "experiment/results/store/assessment_spool.h"

#include "experiment/results/store/database.h"
#include "experiment/results/store/row_writer.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/stored_rows.h"

namespace jaywalk {

/// The table of a store, in a temporary one.
class AssessmentSpool::Impl {
 public:
  Impl()
      : database_({}, Database::Mode::temporary),
        tables_(database_),
        rows_(database_, description_) {
    database_.execute("BEGIN");
  }

  [[nodiscard]] Database& database() { return database_; }
  [[nodiscard]] const Database& database() const { return database_; }
  void add(std::int64_t test_id, const std::vector<AssessmentRow>& assessments) {
    rows_.write(test_id, assessments);
  }

 private:
  struct Tables {
    explicit Tables(Database& database) { create_tables(database, Placement(std::nullopt)); }
  };
  Database database_;
  Tables tables_;
  ExperimentDescription description_;
  RowWriter rows_;
};

AssessmentSpool::AssessmentSpool() : impl_(std::make_unique<Impl>()) {}
AssessmentSpool::~AssessmentSpool() = default;

void AssessmentSpool::add(std::int64_t test_id, const std::vector<AssessmentRow>& assessments) {
  impl_->add(test_id, assessments);
}

void AssessmentSpool::for_each(
    const std::function<void(std::int64_t test_id, const std::vector<AssessmentRow>& assessments)>&
        callback) {
  read_all_assessments(impl_->database(), callback);
}

std::optional<std::string> AssessmentSpool::failure() const { return impl_->database().failure(); }

}  // namespace jaywalk
