// SPDX-License-Identifier: Apache-2.0
// A table of each option's value, by bins of the features: Q(lambda) after Watkins ("Learning from
// delayed rewards", 1989), in the forward view. Episodes are processed backwards. Real later
// rewards count in part (Monte Carlo), but only while the choices after it were the best known
// ones: exploration must not lower an option's value.

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "experiment/policy/learner.h"

namespace jaywalk {
namespace {

constexpr double kTableRate = 0.05;

using Bins = std::vector<std::int32_t>;

/// The values of one situation's options.
struct WorthOfOptions {
  std::vector<double> values;
  std::vector<std::uint64_t> tried;
};

class QTable final : public Learner {
 public:
  QTable(PolicyShape shape, LearnerSettings settings)
      : shape_(std::move(shape)), settings_(std::move(settings)) {}

  void weigh(std::span<const double> features, std::span<const std::uint32_t> options, Mode mode,
             std::span<double> probabilities) const override {
    const auto found = rows_.find(bins_of(features));
    const WorthOfOptions* const row = found == rows_.end() ? nullptr : &found->second;
    const std::vector<bool> best = best_of(row, options, mode);
    const auto count = static_cast<double>(std::ranges::count(best, true));
    const double chance = mode == Mode::explore ? exploration() : 0;
    for (std::size_t i = 0; i < options.size(); ++i) {
      probabilities[i] = chance / static_cast<double>(options.size());
      if (best[i]) probabilities[i] += (1 - chance) / count;
    }
  }

  [[nodiscard]] double value(std::span<const double> features) const override {
    const auto found = rows_.find(bins_of(features));
    if (found == rows_.end()) return 0;
    std::vector<std::uint32_t> all(shape_.options.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    return greatest(found->second, all);
  }

  void learn(std::span<const Episode> generation) override {
    for (const Episode& episode : generation) {
      double target = 0;
      for (std::size_t i = episode.size(); i-- > 0;) {
        const Transition& decision = episode[i];
        const double follows = i + 1 == episode.size() ? 0 : expected_from(episode[i + 1], target);
        target = decision.reward + decision.discount * follows;
        correct(decision, target);
      }
      ++episodes_;
    }
  }

  [[nodiscard]] nlohmann::json state() const override {
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& [bins, row] : rows_) rows.push_back({bins, row.values, row.tried});
    return {{"episodes", episodes_}, {"rows", std::move(rows)}};
  }

  void restore(const nlohmann::json& state) override {
    rows_.clear();
    episodes_ = state.at("episodes").get<std::uint64_t>();
    for (const nlohmann::json& each : state.at("rows")) {
      WorthOfOptions row{.values = each.at(1).get<std::vector<double>>(),
                         .tried = each.at(2).get<std::vector<std::uint64_t>>()};
      const Bins bins = each.at(0).get<Bins>();
      if (bins.size() != shape_.features || row.values.size() != shape_.options.size() ||
          row.tried.size() != shape_.options.size()) {
        throw std::invalid_argument("a row of the table has another size");
      }
      rows_[bins] = std::move(row);
    }
  }

 private:
  [[nodiscard]] Bins bins_of(std::span<const double> features) const {
    constexpr double kMost = 1e9;
    Bins bins;
    for (std::size_t i = 0; i < features.size(); ++i) {
      const double width = i < settings_.bins.size() ? settings_.bins[i] : 1;
      bins.push_back(
          static_cast<std::int32_t>(std::clamp(std::floor(features[i] / width), -kMost, kMost)));
    }
    return bins;
  }

  /// The preferred options: those not tried yet while exploring, else those worth most.
  [[nodiscard]] static std::vector<bool> best_of(const WorthOfOptions* row,
                                                 std::span<const std::uint32_t> options,
                                                 Mode mode) {
    std::vector<bool> best(options.size(), true);
    if (row == nullptr) return best;
    const auto is_tried = [row](std::uint32_t option) { return row->tried[option] > 0; };
    const auto tried = std::ranges::count_if(options, is_tried);
    if (tried == 0) return best;
    const bool prefers_new =
        mode == Mode::explore && tried < static_cast<std::ptrdiff_t>(options.size());
    const double most = greatest(*row, options);
    for (std::size_t i = 0; i < options.size(); ++i) {
      best[i] = prefers_new ? !is_tried(options[i])
                            : is_tried(options[i]) && row->values[options[i]] == most;
    }
    return best;
  }

  /// The greatest value of the options that were tried; 0 if none was.
  [[nodiscard]] static double greatest(const WorthOfOptions& row,
                                       std::span<const std::uint32_t> options) {
    double most = 0;
    bool any = false;
    for (const std::uint32_t option : options) {
      if (row.tried[option] == 0) continue;
      most = any ? std::max(most, row.values[option]) : row.values[option];
      any = true;
    }
    return most;
  }

  [[nodiscard]] double exploration() const {
    const double halvings = static_cast<double>(episodes_) / settings_.halves_after;
    return std::max(settings_.explores_least, settings_.explores * std::exp2(-halvings));
  }

  /// The reward expected from a choice whose own return was `came`.
  [[nodiscard]] double expected_from(const Transition& next, double came) const {
    const auto found = rows_.find(bins_of(next.features));
    if (found == rows_.end()) return came;
    const double most = greatest(found->second, next.options);
    const std::uint32_t chosen = next.options[next.chosen];
    const bool was_best = found->second.values[chosen] >= most;
    const double trace = was_best ? settings_.trace : 0;
    return (1 - trace) * most + trace * came;
  }

  void correct(const Transition& decision, double target) {
    WorthOfOptions& row = rows_[bins_of(decision.features)];
    row.values.resize(shape_.options.size());
    row.tried.resize(shape_.options.size());
    const std::uint32_t chosen = decision.options[decision.chosen];
    const auto times = static_cast<double>(++row.tried[chosen]);
    double& value = row.values[chosen];
    value += std::max(settings_.rate.value_or(kTableRate), 1 / times) * (target - value);
  }

  PolicyShape shape_;
  LearnerSettings settings_;
  std::map<Bins, WorthOfOptions> rows_;
  std::uint64_t episodes_ = 0;
};

}  // namespace

std::unique_ptr<Learner> learners::q_table(const PolicyShape& shape,
                                           const LearnerSettings& settings, std::uint64_t) {
  return std::make_unique<QTable>(shape, settings);
}

}  // namespace jaywalk
