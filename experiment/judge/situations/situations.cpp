// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/situations/situations.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::vector<std::string> split(std::string_view bins) {
  std::vector<std::string> names;
  while (true) {
    const std::size_t bar = bins.find('|');
    names.emplace_back(bins.substr(0, bar));
    if (bar == std::string_view::npos) return names;
    bins.remove_prefix(bar + 1);
  }
}

struct Single {
  std::string_view name;
  std::string_view bins;
  std::string_view summary;
  std::optional<std::uint32_t> (*bin)(const Situation&);
};
struct SituationPair {
  std::string_view name;
  std::string_view first;
  std::string_view second;
};

constexpr std::array kSingles = {
#define JAYWALK_SITUATION(name, bins, summary) Single{#name, bins, summary, &situation::name},
#define JAYWALK_SITUATION_PAIR(name, first, second)
#include "experiment/judge/situations/situations.def"
#undef JAYWALK_SITUATION
#undef JAYWALK_SITUATION_PAIR
};

constexpr std::array kPairs = {
#define JAYWALK_SITUATION(name, bins, summary)
#define JAYWALK_SITUATION_PAIR(name, first, second) SituationPair{#name, #first, #second},
#include "experiment/judge/situations/situations.def"
#undef JAYWALK_SITUATION
#undef JAYWALK_SITUATION_PAIR
};

constexpr std::size_t index_of(std::string_view name) {
  std::size_t index = 0;
  while (kSingles[index].name != name) ++index;
  return index;
}

std::vector<SituationItem> make_items() {
  std::vector<SituationItem> items;
  for (const Single& single : kSingles) {
    items.push_back({single.name, std::string(single.summary), split(single.bins)});
  }
  for (const SituationPair& pair : kPairs) {
    const SituationItem& first = items[index_of(pair.first)];
    const SituationItem& second = items[index_of(pair.second)];
    SituationItem item{pair.name, fmt::format("{} with {}", pair.first, pair.second), {}};
    for (const std::string& one : first.bins) {
      for (const std::string& other : second.bins) item.bins.push_back(one + ", " + other);
    }
    items.push_back(std::move(item));
  }
  return items;
}

const RecordedEvent* first_precondition(const Recording& recording) {
  const auto found = std::ranges::find_if(recording.events(), [&](const RecordedEvent& event) {
    return event.kind == "precondition" && event.actor && event.tick > 0 &&
           event.tick < recording.scenes();
  });
  return found == recording.events().end() ? nullptr : &*found;
}

}  // namespace

std::span<const SituationItem> situation_items() {
  static const std::vector<SituationItem> kItems = make_items();
  return kItems;
}

SituationBins covered_bins(const Recording& recording, const Ground& ground) {
  SituationBins bins(situation_items().size());
  const RecordedEvent* const event = first_precondition(recording);
  if (event == nullptr) return bins;
  const TestView view(recording, ground);
  const Situation situation{view, *event->actor, event->tick};
  for (std::size_t i = 0; i < kSingles.size(); ++i) bins[i] = kSingles[i].bin(situation);
  for (std::size_t i = 0; i < kPairs.size(); ++i) {
    const std::size_t second = index_of(kPairs[i].second);
    const auto& one = bins[index_of(kPairs[i].first)];
    const auto& other = bins[second];
    if (!one || !other) continue;
    const auto width = static_cast<std::uint32_t>(situation_items()[second].bins.size());
    bins[kSingles.size() + i] = *one * width + *other;
  }
  return bins;
}

SituationCoverage::SituationCoverage() {
  for (const SituationItem& item : situation_items()) {
    counts_.emplace_back(item.bins.size());
    bins_ += item.bins.size();
  }
}

void SituationCoverage::add(const SituationBins& test) {
  ++tests_;
  const std::uint64_t before = covered_;
  for (std::size_t item = 0; item < test.size(); ++item) {
    if (!test[item]) continue;
    if (counts_[item][*test[item]]++ == 0) ++covered_;
  }
  if (covered_ > before) growth_.push_back({tests_, covered_});
}

std::uint64_t SituationCoverage::bins(const ReachableBins& reachable) const {
  if (reachable.empty()) return bins_;
  std::uint64_t bins = 0;
  for (std::size_t item = 0; item < counts_.size(); ++item) {
    for (std::size_t bin = 0; bin < counts_[item].size(); ++bin) {
      if (reachable[item][bin] || counts_[item][bin] > 0) ++bins;
    }
  }
  return bins;
}

std::uint64_t SituationCoverage::covered_after(std::uint64_t tests) const {
  std::uint64_t covered = 0;
  for (const Growth& step : growth_) {
    if (step.tests <= tests) covered = step.covered;
  }
  return covered;
}

}  // namespace jaywalk
