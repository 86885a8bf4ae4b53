#pragma once

// Assessments of any number of tests, kept outside of memory until they can be written into their
// store, which cannot be written while it is read.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/assessment_row.h"

namespace jaywalk {

class AssessmentSpool {
 public:
  AssessmentSpool();
  ~AssessmentSpool();
  AssessmentSpool(const AssessmentSpool&) = delete;
  AssessmentSpool& operator=(const AssessmentSpool&) = delete;

  /// REQUIRES: ascending ids.
  void add(std::int64_t test_id, const std::vector<AssessmentRow>& assessments);
  /// Calls back for each test that has assessments, in their order.
  void for_each(const std::function<void(std::int64_t test_id,
                                         const std::vector<AssessmentRow>& assessments)>& callback);
  /// Why they could not be kept, if so (no space is left for temporary files).
  [[nodiscard]] std::optional<std::string> failure() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jaywalk
