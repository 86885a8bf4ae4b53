// SPDX-License-Identifier: Apache-2.0
#pragma once

// A search space and a SUT that need no simulation: a square whose corner fails.

#include <array>
#include <cmath>
#include <memory>

#include "search/search.h"

namespace jaywalk::search {

/// Two numbers; a first one below -0.5 is invalid.
class Square : public SearchSpace {
 public:
  [[nodiscard]] std::size_t dimension() const override { return 2; }
  [[nodiscard]] std::optional<SequenceBounds> sequences() const override { return std::nullopt; }
  [[nodiscard]] Validity check(const TestInput& input) const override {
    return {input.values.size() == 2 && input.values[0] >= -0.5 ? "" : "too far left"};
  }
  [[nodiscard]] TestInput draw_initial(Random& random) const override {
    return {Form::vector, {random.uniform(-1, 1), random.uniform(-1, 1)}};
  }
  [[nodiscard]] TestInput as_points(const TestInput& input) const override { return input; }
  [[nodiscard]] std::vector<double> signature(const TestInput& input) const override {
    return input.values;
  }
};

/// Its measure `nearness` is 1 at (1, 1) and 0 at a distance of 2. Simulates 5 s.
class CornerSut : public SutModel {
 public:
  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kMeasures; }
  [[nodiscard]] std::unique_ptr<Sut> make() const override;
  [[nodiscard]] std::vector<SutSetting> settings() const override { return {{"corner", "upper"}}; }

  static constexpr std::array kMeasures = {MeasureKind{"nearness", "to the corner"}};

 private:
  Square space_;
};

class CornerRun : public Sut {
 public:
  Outcome run(const TestInput& input, std::size_t) override {
    const double dx = 1 - input.values[0];
    const double dy = 1 - input.values[1];
    return {.simulated_s = 5, .measures = {1 - std::sqrt(dx * dx + dy * dy) / 2}};
  }
};

inline std::unique_ptr<Sut> CornerSut::make() const { return std::make_unique<CornerRun>(); }

inline GeneratorSpec generator_spec(std::string_view name) {
  const GeneratorKind* kind = find_generator(name);
  GeneratorSpec spec{std::string(name), kind, {}};
  for (const NumberParameter& parameter : kind->parameters) spec.values.push_back(parameter.value);
  return spec;
}

inline SearchPlan corner_plan(std::string_view generator, std::uint64_t tests) {
  SearchPlan plan;
  plan.model = std::make_shared<CornerSut>();
  plan.fitness.fails_at = 0.9;
  plan.budget = {.tests = tests, .virtual_s = 0};
  plan.generators = {generator_spec(generator)};
  plan.seed = 3;
  return plan;
}

}  // namespace jaywalk::search
