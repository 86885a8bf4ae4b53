// SPDX-License-Identifier: Apache-2.0
#pragma once

// The initial beliefs of one predicate that a program's agents share, or the constant percepts of
// one that a system's agents share (constant_percepts.h). Agents share the rows until they change
// one (Relation::own_rows), on any thread: the rows do not change, and their indexes are made when
// an agent first needs them.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "interpreter/logic/beliefs/row.h"
#include "interpreter/logic/beliefs/row_index.h"
#include "interpreter/logic/beliefs/rule_table.h"
#include "interpreter/support/containers/hash_index.h"
#include "interpreter/support/containers/ring.h"

namespace jaywalk {

class SharedRows {
 public:
  /// Rows as a relation has them, numbered from 0, without holes. `table` is of a few rules and
  /// nothing else, or null; it outlives the rows, as what they refer to does.
  SharedRows(Ring<Row> rows, const RuleTable* table);

  [[nodiscard]] const Ring<Row>& rows() const { return rows_; }
  [[nodiscard]] std::uint32_t rules() const { return rules_; }
  /// They are percepts, which belief update need not see again.
  [[nodiscard]] bool are_percepts() const {
    return !rows_.empty() && rows_.front().percept_generation == kAlwaysSeen;
  }
  /// The percept_generation of such rows.
  static constexpr std::uint32_t kAlwaysSeen = 0xFFFF'FFFFU;
  [[nodiscard]] const RuleTable* rule_table() const { return table_; }
  /// The index of all rows by an argument, which they have.
  [[nodiscard]] RowIndex& index_of(std::size_t argument) const;
  /// The index of the facts by all arguments.
  [[nodiscard]] HashIndex& facts() const;

 private:
  Ring<Row> rows_;
  std::uint32_t rules_ = 0;
  const RuleTable* table_;
  // Made under the lock, and then only read.
  mutable std::mutex making_;
  mutable std::vector<std::unique_ptr<RowIndex>> made_;
  mutable std::vector<std::atomic<RowIndex*>> by_argument_;
  mutable std::unique_ptr<HashIndex> made_facts_;
  mutable std::atomic<HashIndex*> facts_{nullptr};
};

}  // namespace jaywalk
