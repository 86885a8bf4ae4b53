// SPDX-License-Identifier: Apache-2.0
// Two small networks: the actor gives the probability of each option, the critic the expected
// reward. The actor follows a clipped objective, with the advantage of a choice over the
// expectation as Schulman et al. estimate it ("High-dimensional continuous control using
// generalized advantage estimation", 2016, equation 16). Features, rewards and advantages are
// scaled by all values seen so far. Scaled by one generation alone, the noise that remains in the
// advantages once nearly all is learned would become as large as the advantages that there were to
// learn.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiment/networks/network.h"
#include "experiment/policy/clipped_objective.h"

namespace jaywalk {
namespace {

constexpr double kNetworkRate = 0.003;

using networks::Adam;
using networks::Layer;
using networks::Matrix;
using networks::Network;

/// Mean and deviation of numbers, one after another (Welford).
class SeenScale {
 public:
  void add(double value) {
    count_ += 1;
    const double before = value - mean_;
    mean_ += before / count_;
    squares_ += before * (value - mean_);
  }
  [[nodiscard]] double mean() const { return mean_; }
  /// 1 where there is none.
  [[nodiscard]] double deviation() const {
    const double variance = count_ > 1 ? squares_ / count_ : 0;
    return variance > kLeast ? std::sqrt(variance) : 1;
  }
  [[nodiscard]] nlohmann::json state() const { return {count_, mean_, squares_}; }
  void restore(const nlohmann::json& state) {
    count_ = state.at(0).get<double>();
    mean_ = state.at(1).get<double>();
    squares_ = state.at(2).get<double>();
  }

 private:
  static constexpr double kLeast = 1e-12;
  double count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
};

/// The decisions of a generation as columns, and the values that they are learned from.
struct ChoiceBatch {
  std::vector<const Transition*> decisions;
  Matrix features;  // a decision in each column
  /// How much better each choice was than expected, and its return on the common scale.
  std::vector<double> advantages;
  std::vector<double> returns;
};

std::span<const float> numbers(const Matrix& matrix, Eigen::Index column) {
  return {matrix.col(column).data(), static_cast<std::size_t>(matrix.rows())};
}
std::span<float> numbers(Matrix& matrix, Eigen::Index column) {
  return {matrix.col(column).data(), static_cast<std::size_t>(matrix.rows())};
}

/// Exploration applies during training only.
void keep_most_probable(std::span<double> probabilities) {
  const auto most = std::ranges::max_element(probabilities);
  for (double& each : probabilities) each = &each == &*most ? 1 : 0;
}

nlohmann::json numbers_of(const Network& network) {
  nlohmann::json layers = nlohmann::json::array();
  for (const Layer* const layer : network.layers()) {
    layers.push_back(
        {std::vector<float>(layer->weights.reshaped().begin(), layer->weights.reshaped().end()),
         std::vector<float>(layer->bias.begin(), layer->bias.end())});
  }
  return layers;
}

template <class Target>
void fill(Target& target, const nlohmann::json& from) {
  const auto numbers = from.get<std::vector<float>>();
  if (std::cmp_not_equal(numbers.size(), target.size())) {
    throw std::invalid_argument("a layer of the network has another size");
  }
  // A weight beyond the range of float has become infinite.
  if (!std::ranges::all_of(numbers, [](float each) { return std::isfinite(each); })) {
    throw std::invalid_argument("a weight of the network is too large");
  }
  std::ranges::copy(numbers, target.data());
}

void restore_numbers(Network& network, const nlohmann::json& state) {
  std::size_t index = 0;
  for (Layer* const layer : network.layers()) {
    fill(layer->weights, state.at(index).at(0));
    fill(layer->bias, state.at(index).at(1));
    ++index;
  }
}

nlohmann::json memory_of(const Adam& optimiser) {
  const Adam::Memory memory = optimiser.memory();
  return {memory.steps, memory.moments};
}

void restore_memory(Adam& optimiser, const nlohmann::json& state) {
  if (!optimiser.restore(
          {.steps = state.at(0).get<int>(), .moments = state.at(1).get<std::vector<float>>()})) {
    throw std::invalid_argument("the optimiser has another size");
  }
}

class ActorCritic final : public Learner {
 public:
  ActorCritic(const PolicyShape& shape, const LearnerSettings& settings, std::uint64_t seed)
      : shape_(shape),
        settings_(settings),
        random_(seed),
        actor_(network_shape(static_cast<Eigen::Index>(shape.options.size())), random_),
        critic_(network_shape(1), random_),
        actor_steps_(adam()),
        critic_steps_(adam()),
        features_(shape.features) {
    actor_.add_to(actor_steps_);
    critic_.add_to(critic_steps_);
  }

  void weigh(std::span<const double> features, std::span<const std::uint32_t> options, Mode mode,
             std::span<double> probabilities) const override {
    const Matrix scores = actor_.output(scaled(features));
    softmax(numbers(scores, 0), options, probabilities);
    if (mode == Mode::exploit) keep_most_probable(probabilities);
  }

  [[nodiscard]] double value(std::span<const double> features) const override {
    return static_cast<double>(critic_.output(scaled(features))(0, 0)) * returns_.deviation();
  }

  void learn(std::span<const Episode> generation) override {
    // Scales first, then one batch, by which all passes improve: the policy that chose stays the
    // reference of the clipped objective.
    note_scales(generation);
    episodes_ += generation.size();
    ChoiceBatch batch = batch_of(generation);
    if (batch.decisions.empty()) return;
    for (std::uint32_t pass = 0; pass < settings_.passes; ++pass) {
      improve_actor(batch);
      improve_critic(batch);
    }
  }

  [[nodiscard]] nlohmann::json state() const override {
    nlohmann::json features = nlohmann::json::array();
    for (const SeenScale& scale : features_) features.push_back(scale.state());
    return {{"actor", numbers_of(actor_)},     {"actor_steps", memory_of(actor_steps_)},
            {"critic", numbers_of(critic_)},   {"critic_steps", memory_of(critic_steps_)},
            {"features", std::move(features)}, {"returns", returns_.state()},
            {"episodes", episodes_},           {"advantages", advantages_.state()}};
  }

  void restore(const nlohmann::json& state) override {
    restore_numbers(actor_, state.at("actor"));
    restore_memory(actor_steps_, state.at("actor_steps"));
    restore_numbers(critic_, state.at("critic"));
    restore_memory(critic_steps_, state.at("critic_steps"));
    if (state.at("features").size() != features_.size()) {
      throw std::invalid_argument("there are more features, or fewer");
    }
    for (std::size_t i = 0; i < features_.size(); ++i) {
      features_[i].restore(state.at("features").at(i));
    }
    returns_.restore(state.at("returns"));
    if (!state.contains("episodes")) return;  // a file from before they were kept
    episodes_ = state.at("episodes").get<std::uint64_t>();
    advantages_.restore(state.at("advantages"));
  }

 private:
  [[nodiscard]] networks::NetworkShape network_shape(Eigen::Index outputs) const {
    return {.inputs = static_cast<Eigen::Index>(std::max<std::size_t>(shape_.features, 1)),
            .hidden = static_cast<Eigen::Index>(settings_.hidden),
            .outputs = outputs,
            .slope = 0.01F};
  }
  [[nodiscard]] Adam adam() const {
    return Adam({.rate = static_cast<float>(settings_.rate.value_or(kNetworkRate)),
                 .beta1 = 0.9F,
                 .beta2 = 0.999F,
                 .epsilon = 1e-8F});
  }

  void scale_into(std::span<const double> features, Matrix& columns, Eigen::Index column) const {
    // An observation that training never met may be far from all others.
    constexpr double kMost = 10;
    for (std::size_t i = 0; i < features.size(); ++i) {
      const double number = (features[i] - features_[i].mean()) / features_[i].deviation();
      columns(static_cast<Eigen::Index>(i), column) =
          static_cast<float>(std::clamp(number, -kMost, kMost));
    }
  }
  [[nodiscard]] Matrix scaled(std::span<const double> features) const {
    Matrix column =
        Matrix::Zero(static_cast<Eigen::Index>(std::max<std::size_t>(features.size(), 1)), 1);
    scale_into(features, column, 0);
    return column;
  }

  void note_scales(std::span<const Episode> generation) {
    for (const Episode& episode : generation) {
      // Discounted returns, from the end of the episode; what follows the last decision is worth 0.
      double follows = 0;
      for (std::size_t i = episode.size(); i-- > 0;) {
        follows = episode[i].reward + episode[i].discount * follows;
        returns_.add(follows);
        for (std::size_t f = 0; f < features_.size(); ++f) features_[f].add(episode[i].features[f]);
      }
    }
  }

  [[nodiscard]] ChoiceBatch batch_of(std::span<const Episode> generation) {
    ChoiceBatch batch;
    for (const Episode& episode : generation) {
      for (const Transition& decision : episode) batch.decisions.push_back(&decision);
    }
    const auto count = static_cast<Eigen::Index>(batch.decisions.size());
    batch.features =
        Matrix::Zero(static_cast<Eigen::Index>(std::max<std::size_t>(shape_.features, 1)), count);
    for (Eigen::Index i = 0; i < count; ++i) {
      scale_into(batch.decisions[static_cast<std::size_t>(i)]->features, batch.features, i);
    }
    if (count > 0) estimate(generation, batch);
    return batch;
  }

  /// Advantages by the critic as it is, less their mean, on the scale of all so far.
  void estimate(std::span<const Episode> generation, ChoiceBatch& batch) {
    const Matrix expected = critic_.output(batch.features);
    batch.advantages.resize(batch.decisions.size());
    batch.returns.resize(batch.decisions.size());
    std::size_t first = 0;
    for (const Episode& episode : generation) {
      double advantage = 0;
      double next = 0;
      for (std::size_t i = episode.size(); i-- > 0;) {
        const Transition& decision = episode[i];
        const auto here = static_cast<double>(expected(0, static_cast<Eigen::Index>(first + i)));
        const double reward = decision.reward / returns_.deviation();
        // Equation 16, from the end: the temporal difference, and the discounted advantage behind
        // it.
        advantage = reward + decision.discount * next - here +
                    decision.discount * settings_.trace * advantage;
        batch.advantages[first + i] = advantage;
        // The critic's target: its expectation plus the advantage.
        batch.returns[first + i] = advantage + here;
        next = here;
      }
      first += episode.size();
    }
    SeenScale own;
    for (const double advantage : batch.advantages) {
      own.add(advantage);
      advantages_.add(advantage);
    }
    for (double& advantage : batch.advantages) {
      advantage = (advantage - own.mean()) / advantages_.deviation();
    }
  }

  /// The present weight of entropy: large at first, so that options that rarely succeed are tried
  /// often enough before they are given up.
  [[nodiscard]] double entropy() const {
    const double halvings = static_cast<double>(episodes_) / settings_.halves_after;
    return std::max(settings_.entropy_least, settings_.entropy * std::exp2(-halvings));
  }

  void improve_actor(const ChoiceBatch& batch) {
    const Matrix scores = actor_.forward(batch.features);
    Matrix gradient = Matrix::Zero(scores.rows(), scores.cols());
    std::vector<double> probabilities;
    const ObjectiveSettings objective{.clip = settings_.clip, .entropy = entropy()};
    for (Eigen::Index i = 0; i < scores.cols(); ++i) {
      const Transition& decision = *batch.decisions[static_cast<std::size_t>(i)];
      probabilities.resize(decision.options.size());
      softmax(numbers(scores, i), decision.options, probabilities);
      add_clipped_gradient(decision, batch.advantages[static_cast<std::size_t>(i)], probabilities,
                           objective, numbers(gradient, i));
    }
    actor_.clear_gradients();
    // The mean over the batch, so that the rate does not depend on its size.
    actor_.backward(gradient / static_cast<float>(scores.cols()));
    actor_steps_.step();
  }

  void improve_critic(const ChoiceBatch& batch) {
    const Matrix expected = critic_.forward(batch.features);
    Matrix gradient(1, expected.cols());
    for (Eigen::Index i = 0; i < expected.cols(); ++i) {
      const double error =
          static_cast<double>(expected(0, i)) - batch.returns[static_cast<std::size_t>(i)];
      // The gradient of the mean squared error.
      gradient(0, i) = static_cast<float>(2 * error / static_cast<double>(expected.cols()));
    }
    critic_.clear_gradients();
    critic_.backward(gradient);
    critic_steps_.step();
  }

  PolicyShape shape_;
  LearnerSettings settings_;
  networks::Random random_;
  Network actor_;
  Network critic_;
  Adam actor_steps_;
  Adam critic_steps_;
  std::vector<SeenScale> features_;
  SeenScale returns_;
  SeenScale advantages_;
  std::uint64_t episodes_ = 0;
};

}  // namespace

std::unique_ptr<Learner> learners::actor_critic(const PolicyShape& shape,
                                                const LearnerSettings& settings,
                                                std::uint64_t seed) {
  return std::make_unique<ActorCritic>(shape, settings, seed);
}

}  // namespace jaywalk
