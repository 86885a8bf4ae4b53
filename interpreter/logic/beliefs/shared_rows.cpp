// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/shared_rows.h"

#include <algorithm>
#include <utility>

namespace jaywalk {
namespace {

std::size_t arity_of(const Ring<Row>& rows) {
  if (rows.empty()) return 0;
  const Value literal = rows.front().literal();
  return literal.is_structure() ? literal.structure()->arity : 0;
}

}  // namespace

SharedRows::SharedRows(Ring<Row> rows, const RuleTable* table)
    : rows_(std::move(rows)), table_(table), made_(arity_of(rows_)), by_argument_(arity_of(rows_)) {
  rules_ = static_cast<std::uint32_t>(std::count_if(
      rows_.begin(), rows_.end(), [](const Row& row) { return row.rule != nullptr; }));
}

RowIndex& SharedRows::index_of(std::size_t argument) const {
  std::atomic<RowIndex*>& known = by_argument_[argument];
  if (RowIndex* const index = known.load(std::memory_order_acquire)) return *index;
  const std::lock_guard guard(making_);
  if (known.load(std::memory_order_relaxed) == nullptr) {
    made_[argument] = make_row_index(rows_, 0, argument);
    known.store(made_[argument].get(), std::memory_order_release);
  }
  return *made_[argument];
}

HashIndex& SharedRows::facts() const {
  if (HashIndex* const index = facts_.load(std::memory_order_acquire)) return *index;
  const std::lock_guard guard(making_);
  if (made_facts_ == nullptr) {
    made_facts_ = make_fact_index(rows_, 0);
    facts_.store(made_facts_.get(), std::memory_order_release);
  }
  return *made_facts_;
}

}  // namespace jaywalk
