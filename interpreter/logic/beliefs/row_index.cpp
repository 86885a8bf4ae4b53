// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/row_index.h"

#include <algorithm>

namespace jaywalk {

const RowIndex::Entry* RowIndex::find(std::uint32_t key) const {
  if (table_.empty()) return nullptr;
  for (std::size_t i = place(key);; i = (i + 1) & (table_.size() - 1)) {
    if (table_[i].key == key) return &table_[i];
    if (table_[i].key == kFree) return nullptr;
  }
}

// To which a row with a value is added.
RowIndex::Entry& RowIndex::entry(std::uint32_t key, Bits value) {
  if (Entry* const known = find(key)) {
    if (known->count == 0) known->value = value;
    if (known->value != value) known->value = kVarious;
    return *known;
  }
  if (3 * (taken_ + 1) > 2 * table_.size()) grow();
  std::size_t i = place(key);
  while (table_[i].key != kFree) i = (i + 1) & (table_.size() - 1);
  ++taken_;
  table_[i].key = key;
  table_[i].value = value;
  return table_[i];
}

// Keys whose rows have all gone are left behind.
void RowIndex::grow() {
  const auto live = static_cast<std::size_t>(
      std::count_if(table_.begin(), table_.end(), [](const Entry& e) { return e.count > 0; }));
  std::size_t size = 8;
  while (size < 2 * (live + 1)) size *= 2;
  std::vector<Entry> old(size);
  old.swap(table_);
  taken_ = live;
  for (const Entry& each : old) {
    if (each.count == 0) continue;
    std::size_t i = place(each.key);
    while (table_[i].key != kFree) i = (i + 1) & (table_.size() - 1);
    table_[i] = each;
  }
}

void RowIndex::add_newest(std::uint32_t key, Bits value) {
  const std::int64_t seq = first_ + static_cast<std::int64_t>(links_.size());
  if (key == kHoleKey) {
    links_.push_back({});
    return;
  }
  Entry& chain = entry(key, value);
  links_.push_back({key, chain.newest});
  chain.newest = row_of(seq);
  if (chain.oldest == kNoRow) chain.oldest = chain.newest;
  ++chain.count;
}

void RowIndex::add_oldest(std::uint32_t key, Bits value) {
  Entry& chain = entry(key, value);
  const std::int32_t row = row_of(first_ - 1);
  if (chain.count == 0) {
    chain.newest = row;
  } else {
    link(seq_of(chain.oldest)).older = row;
  }
  links_.push_front({key, kNoRow});
  --first_;
  chain.oldest = row;
  ++chain.count;
}

void RowIndex::erase(std::int64_t seq) {
  Entry* const chain = find(link(seq).key);
  if (chain != nullptr && chain->count > 0) --chain->count;
}

void RowIndex::drop_newest() {
  const std::int64_t seq = first_ + static_cast<std::int64_t>(links_.size()) - 1;
  const Link& last = link(seq);
  Entry* const chain = find(last.key);
  if (chain != nullptr && chain->newest == row_of(seq)) {
    chain->newest = last.older;
    if (chain->oldest == row_of(seq)) chain->oldest = kNoRow;
  }
  links_.pop_back();
}

void RowIndex::skip(std::uint32_t key, std::int64_t newer, std::int64_t older) {
  Entry* const chain = find(key);
  if (newer != kNone) {
    link(newer).older = row_of(older);
  } else if (chain != nullptr) {
    chain->newest = row_of(older);
  }
  if (older == kNone && chain != nullptr) chain->oldest = row_of(newer);
}

}  // namespace jaywalk
