// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/controller_notes.h"

#include <functional>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {

void ControllerNotes::add(std::uint64_t place, std::span<const std::string> notes) {
  if (notes.empty()) return;
  const std::lock_guard lock(mutex_);
  for (const std::string& note : notes) {
    const std::size_t hash = std::hash<std::string>()(note);
    Entry& entry = entries_[hash];
    if (entry.tests++ > 0 && entry.first <= place) continue;
    shown_.erase({entry.first, hash});
    shown_.insert({place, hash});
    entry.first = place;
    entry.text = note;
    if (shown_.size() <= kMostShown) continue;
    const auto last = std::prev(shown_.end());
    entries_[last->second].text.clear();
    shown_.erase(last);
  }
}

std::vector<std::string> ControllerNotes::texts() const {
  std::vector<std::string> texts;
  for (const auto& [place, hash] : shown_) {
    const Entry& entry = entries_.at(hash);
    texts.push_back(fmt::format("in {}, {}", counted(entry.tests, "test"), entry.text));
  }
  if (entries_.size() > shown_.size()) {
    texts.push_back(
        fmt::format("and {} other notes about controllers", entries_.size() - shown_.size()));
  }
  return texts;
}

}  // namespace jaywalk
