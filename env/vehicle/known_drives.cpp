#include "env/vehicle/known_drives.h"

#include <algorithm>
#include <utility>

namespace jaywalk {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

}  // namespace

void KnownDrives::forget() {
  nodes_.assign(1, {});
  at_ = 0;
  bytes_ = 0;
  full_ = false;
}

std::optional<double> KnownDrives::follow(const std::string& view) {
  for (std::size_t i = nodes_[at_].next; i != 0; i = nodes_[i].sibling) {
    if (nodes_[i].step.view != view) continue;
    at_ = i;
    return nodes_[i].step.answer;
  }
  return std::nullopt;
}

void KnownDrives::add(Step step) {
  bytes_ += sizeof(Node) + step.view.size();
  // From a step that is missing no other can go on.
  full_ = full_ || bytes_ > kMostBytes;
  if (full_) return;
  const std::size_t added = nodes_.size();
  nodes_.push_back({.step = std::move(step), .before = at_, .sibling = nodes_[at_].next});
  nodes_[at_].next = added;
  at_ = added;
}

KnownDrives::Way KnownDrives::way_here() const {
  Way way;
  for (std::size_t i = at_; i != 0; i = nodes_[i].before) {
    way.views.push_back(nodes_[i].step.view);
    way.answers.push_back(nodes_[i].step.answer);
  }
  std::ranges::reverse(way.views);
  std::ranges::reverse(way.answers);
  return way;
}

}  // namespace jaywalk
