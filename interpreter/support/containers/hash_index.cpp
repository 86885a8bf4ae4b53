// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/containers/hash_index.h"

#include <algorithm>

namespace jaywalk {

void HashIndex::grow() {
  constexpr std::size_t kLeast = 16;
  std::vector<Entry> old(std::max(kLeast, 2 * table_.size()));
  old.swap(table_);
  shift_ = 32;
  for (std::size_t size = table_.size(); size > 1; size /= 2) --shift_;
  for (const Entry& entry : old) {
    if (entry.hash != 0) put(entry);
  }
}

void HashIndex::erase(std::uint32_t hash, std::int64_t place) {
  const auto counted = static_cast<std::int32_t>(place - origin_);
  const auto is_it = [&](const Entry& entry) { return entry.hash != 0 && entry.place == counted; };
  std::size_t i = home(hash);
  while (table_[i].hash != 0 && !is_it(table_[i])) i = after(i);
  if (table_[i].hash == 0) {
    // Its hash has changed since it was added.
    i = static_cast<std::size_t>(std::find_if(table_.begin(), table_.end(), is_it) -
                                 table_.begin());
  }
  if (i < table_.size()) remove(i);
}

void HashIndex::clear() {
  if (taken_ > 0) std::ranges::fill(table_, Entry{});
  taken_ = 0;
}

// An entry may move up to a gap if that does not lie before its home (Knuth, volume 3, 6.4 R).
void HashIndex::remove(std::size_t gap) {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = after(gap); table_[i].hash != 0; i = after(i)) {
    const std::size_t distance = (i - home(table_[i].hash)) & mask;
    if (distance < ((i - gap) & mask)) continue;
    table_[gap] = table_[i];
    gap = i;
  }
  table_[gap] = {};
  --taken_;
}

}  // namespace jaywalk
