// SPDX-License-Identifier: Apache-2.0
// Which behaviours complement each other.

#include <algorithm>

#include "experiment/compare/kills/kills.h"

namespace jaywalk {
namespace {

double kill_share(const KillCell& cell) {
  return cell.tests == 0 ? 0 : static_cast<double>(cell.kills) / static_cast<double>(cell.tests);
}

/// Looks for the fewest rows by trying, for a defect that few kill, each row that does.
class TeamSearch {
 public:
  explicit TeamSearch(const KillMatrix& matrix) : matrix_(matrix) {
    for (std::size_t defect = 0; defect < matrix.defects.size(); ++defect) {
      if (best_killer(matrix, defect)) open_.push_back(defect);
    }
    best_ = greedy();
  }

  std::vector<std::size_t> find() {
    std::vector<std::size_t> team;
    extend(team, open_);
    std::ranges::sort(best_);
    return best_;
  }

 private:
  [[nodiscard]] bool kills(std::size_t row, std::size_t defect) const {
    return matrix_.rows[row].cells[defect].kills > 0;
  }

  [[nodiscard]] std::vector<std::size_t> without(std::vector<std::size_t> open,
                                                 std::size_t row) const {
    std::erase_if(open, [&](std::size_t defect) { return kills(row, defect); });
    return open;
  }

  [[nodiscard]] std::vector<std::size_t> killers(std::size_t defect) const {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < matrix_.rows.size(); ++row) {
      if (kills(row, defect)) rows.push_back(row);
    }
    return rows;
  }

  /// A team that may not be the smallest: always adds the row that kills most remaining defects.
  [[nodiscard]] std::vector<std::size_t> greedy() const {
    std::vector<std::size_t> team;
    std::vector<std::size_t> open = open_;
    while (!open.empty()) {
      std::size_t chosen = 0;
      std::size_t fewest = open.size();
      for (std::size_t row = 0; row < matrix_.rows.size(); ++row) {
        const std::size_t left = without(open, row).size();
        if (left >= fewest) continue;
        fewest = left;
        chosen = row;
      }
      team.push_back(chosen);
      open = without(open, chosen);
    }
    return team;
  }

  [[nodiscard]] std::uint64_t kills_of(const std::vector<std::size_t>& team) const {
    std::uint64_t sum = 0;
    for (const std::size_t row : team) sum += matrix_.rows[row].kills();
    return sum;
  }

  [[nodiscard]] bool is_better(std::vector<std::size_t> team) const {
    if (team.size() != best_.size()) return team.size() < best_.size();
    const std::uint64_t ours = kills_of(team);
    const std::uint64_t theirs = kills_of(best_);
    if (ours != theirs) return ours > theirs;
    std::vector<std::size_t> other = best_;
    std::ranges::sort(team);
    std::ranges::sort(other);
    return team < other;
  }

  void extend(std::vector<std::size_t>& team, const std::vector<std::size_t>& open) {
    if (open.empty()) {
      if (is_better(team)) best_ = team;
      return;
    }
    if (team.size() >= best_.size() || ++steps_ > kMostSteps) return;
    // Some row must kill this defect: branching over the fewest rows keeps the tree small.
    const auto rarest = std::ranges::min_element(
        open, {}, [&](std::size_t defect) { return killers(defect).size(); });
    for (const std::size_t row : killers(*rarest)) {
      team.push_back(row);
      extend(team, without(open, row));
      team.pop_back();
    }
  }

  /// Reached by no matrix of a sensible size; the greedy team is good then.
  static constexpr std::uint64_t kMostSteps = 200'000;

  const KillMatrix& matrix_;
  std::vector<std::size_t> open_;
  std::vector<std::size_t> best_;
  std::uint64_t steps_ = 0;
};

}  // namespace

std::vector<std::size_t> survivors(const KillMatrix& matrix) {
  std::vector<std::size_t> alive;
  for (std::size_t defect = 0; defect < matrix.defects.size(); ++defect) {
    if (!best_killer(matrix, defect)) alive.push_back(defect);
  }
  return alive;
}

std::optional<std::size_t> best_killer(const KillMatrix& matrix, std::size_t defect) {
  std::optional<std::size_t> best;
  double highest = 0;
  for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
    const double share = kill_share(matrix.rows[row].cells[defect]);
    if (share <= highest) continue;
    highest = share;
    best = row;
  }
  return best;
}

std::vector<std::size_t> smallest_team(const KillMatrix& matrix) {
  return TeamSearch(matrix).find();
}

}  // namespace jaywalk
