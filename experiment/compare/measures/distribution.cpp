// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/distribution.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <queue>
#include <span>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "experiment/scenario/files/temporary.h"

namespace jaywalk {
namespace {

/// Zeros of either sign have one order, too.
bool is_less(double left, double right) {
  return left < right || (left == right && std::signbit(left) && !std::signbit(right));
}

/// Takes ascending values of which the number is known.
class DistributionMaker {
 public:
  explicit DistributionMaker(std::uint64_t count) : result_{.count = count} {
    constexpr std::array kParts = {0.25, 0.5, 0.75};
    for (std::size_t i = 0; i < kParts.size() && count > 0; ++i) {
      // Hyndman and Fan's type 7: between the two values around (n - 1) p.
      const double at = kParts[i] * static_cast<double>(count - 1);
      places_[i].below = static_cast<std::uint64_t>(at);
      places_[i].rest = at - static_cast<double>(places_[i].below);
    }
  }

  void add(double value) {
    if (seen_ == 0) result_.least = value;
    result_.greatest = value;
    result_.mean += value;
    for (Place& place : places_) {
      if (seen_ == place.below) place.low = place.high = value;
      if (seen_ == place.below + 1) place.high = value;
    }
    ++seen_;
  }

  Distribution finish() {
    if (result_.count == 0) return result_;
    result_.mean /= static_cast<double>(result_.count);
    result_.lower_quartile = quantile(places_[0]);
    result_.median = quantile(places_[1]);
    result_.upper_quartile = quantile(places_[2]);
    return result_;
  }

 private:
  /// Between two neighbours.
  struct Place {
    std::uint64_t below = 0;
    double rest = 0;
    double low = 0;
    double high = 0;
  };

  static double quantile(const Place& place) {
    if (place.rest == 0 || place.low == place.high) return place.low;
    return place.low + place.rest * (place.high - place.low);
  }

  Distribution result_;
  std::uint64_t seen_ = 0;
  std::array<Place, 3> places_;
};

}  // namespace

Distribution distribution(std::vector<double> values) {
  std::ranges::sort(values, is_less);
  DistributionMaker maker(values.size());
  for (const double value : values) maker.add(value);
  return maker.finish();
}

/// Values one after another.
class ValueColumns::File {
 public:
  File() : descriptor_(open_unnamed()) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Writes the values to the file and sets their place in it; false if that fails.
  bool append(std::span<const double> values, Run& run) {
    run = {.first = size_, .count = values.size()};
    const auto bytes = std::as_bytes(values);
    for (std::size_t done = 0; done < bytes.size();) {
      const auto at = static_cast<off_t>(size_ * sizeof(double) + done);
      const ssize_t more = ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done, at);
      if (more < 0 && errno == EINTR) continue;
      if (more <= 0) return false;
      done += static_cast<std::size_t>(more);
    }
    size_ += values.size();
    return true;
  }

  void read(std::uint64_t first, std::span<double> values) const {
    const auto bytes = std::as_writable_bytes(values);
    for (std::size_t done = 0; done < bytes.size();) {
      const auto at = static_cast<off_t>(first * sizeof(double) + done);
      const ssize_t more = ::pread(descriptor_, bytes.data() + done, bytes.size() - done, at);
      if (more < 0 && errno == EINTR) continue;
      if (more <= 0) throw std::system_error(errno, std::generic_category(), "a temporary file");
      done += static_cast<std::size_t>(more);
    }
  }

 private:
  int descriptor_;
  std::uint64_t size_ = 0;
};

ValueColumns::ValueColumns(std::size_t columns, std::size_t most)
    : columns_(columns), most_(most) {}
ValueColumns::~ValueColumns() = default;

void ValueColumns::add(std::size_t column, double value) {
  columns_[column].in_memory.push_back(value);
  if (++in_memory_ >= most_) spill();
}

void ValueColumns::spill() {
  if (!file_) file_ = std::make_unique<File>();
  for (Column& column : columns_) {
    if (column.in_memory.empty()) continue;
    std::ranges::sort(column.in_memory, is_less);
    Run run;
    if (!file_->append(column.in_memory, run)) {
      // The disk is full: everything stays in memory from now on.
      most_ = SIZE_MAX;
      return;
    }
    column.runs.push_back(run);
    in_memory_ -= column.in_memory.size();
    std::vector<double>().swap(column.in_memory);
  }
}

Distribution ValueColumns::distribution(std::size_t column) const {
  const Column& wanted = columns_[column];
  if (wanted.runs.empty()) return jaywalk::distribution(wanted.in_memory);

  /// The values of a run, a piece of it at a time.
  struct RunSource {
    Run left;
    std::vector<double> piece;
    std::size_t next = 0;
  };
  constexpr std::uint64_t kPiece = 1024;
  std::vector<RunSource> sources;
  std::uint64_t count = wanted.in_memory.size();
  for (const Run& run : wanted.runs) {
    sources.push_back({.left = run, .piece = {}});
    count += run.count;
  }
  sources.push_back({.left = {}, .piece = wanted.in_memory});
  std::ranges::sort(sources.back().piece, is_less);

  const auto is_later = [](const auto& left, const auto& right) {
    return is_less(right.first, left.first);
  };
  using Head = std::pair<double, std::size_t>;
  // Merges the sorted runs: the least of their heads is the next value.
  std::priority_queue<Head, std::vector<Head>, decltype(is_later)> heads(is_later);
  const auto push_next = [&](std::size_t index) {
    RunSource& source = sources[index];
    if (source.next == source.piece.size()) {
      source.piece.resize(std::min(source.left.count, kPiece));
      source.next = 0;
      file_->read(source.left.first, source.piece);
      source.left.first += source.piece.size();
      source.left.count -= source.piece.size();
    }
    if (source.next < source.piece.size()) heads.emplace(source.piece[source.next++], index);
  };
  for (std::size_t i = 0; i < sources.size(); ++i) push_next(i);
  DistributionMaker maker(count);
  while (!heads.empty()) {
    const auto [value, index] = heads.top();
    heads.pop();
    maker.add(value);
    push_next(index);
  }
  return maker.finish();
}

}  // namespace jaywalk
