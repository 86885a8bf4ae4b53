// SPDX-License-Identifier: Apache-2.0
#include "search/library/custom.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace jaywalk::search {
namespace {

/// Vectors, which stand for themselves.
class CustomSpace final : public SearchSpace {
 public:
  explicit CustomSpace(const SystemUnderTest& system) : system_(system) {}

  [[nodiscard]] std::size_t dimension() const override { return system_.dimension; }
  [[nodiscard]] std::optional<SequenceBounds> sequences() const override { return std::nullopt; }
  [[nodiscard]] Validity check(const TestInput& input) const override {
    if (input.values.size() != dimension()) {
      return {fmt::format("{} numbers instead of {}", input.values.size(), dimension())};
    }
    // Not a number is outside as well.
    const auto is_within = [](double value) { return value >= -1 && value <= 1; };
    if (!std::ranges::all_of(input.values, is_within)) return {"a number is not from -1 to 1"};
    return {system_.why_invalid ? system_.why_invalid(input.values) : std::string()};
  }
  [[nodiscard]] TestInput draw_initial(Random& random) const override {
    TestInput input;
    for (std::size_t i = 0; i < dimension(); ++i) input.values.push_back(random.uniform(-1, 1));
    return input;
  }
  [[nodiscard]] TestInput as_points(const TestInput& input) const override {
    return {.form = Form::points, .values = input.values};
  }
  [[nodiscard]] std::vector<double> signature(const TestInput& input) const override {
    return input.values;
  }

 private:
  const SystemUnderTest& system_;
};

class CustomSut final : public Sut {
 public:
  CustomSut(std::unique_ptr<SystemExecutor> executor, const std::vector<std::string>& measures)
      : executor_(std::move(executor)), measures_(measures) {}

  [[nodiscard]] Outcome run(const TestInput& input, std::size_t test) override {
    SystemOutcome found = executor_->run(input.values, test);
    if (!found.error.empty()) {
      found.measures.clear();
    } else if (found.measures.size() != measures_.size()) {
      return {.error = fmt::format("{} measures instead of {}", found.measures.size(),
                                   measures_.size())};
    }
    Outcome outcome{.simulated_s = found.simulated_s, .measures = std::move(found.measures)};
    std::string why = why_nonsense(outcome, "simulated_s", measures_);
    if (!why.empty()) return {.error = std::move(why)};
    outcome.error = std::move(found.error);
    return outcome;
  }

 private:
  std::unique_ptr<SystemExecutor> executor_;
  const std::vector<std::string>& measures_;
};

class CustomModel final : public SutModel {
 public:
  explicit CustomModel(SystemUnderTest system) : system_(std::move(system)), space_(system_) {
    for (const std::string& measure : system_.measures) kinds_.push_back({measure, measure});
  }

  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kinds_; }
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    return std::make_unique<CustomSut>(system_.make_executor(), system_.measures);
  }
  [[nodiscard]] std::vector<SutSetting> settings() const override {
    return {{.name = "system", .value = system_.name}};
  }

 private:
  SystemUnderTest system_;
  CustomSpace space_;
  std::vector<MeasureKind> kinds_;
};

class CustomAsking final : public Generator {
 public:
  explicit CustomAsking(std::unique_ptr<InputGenerator> own) : own_(std::move(own)) {}

  [[nodiscard]] TestInput ask(Asking& asking) override {
    const auto is_valid = [&](std::span<const double> candidate) {
      return asking.valid({.values = {candidate.begin(), candidate.end()}});
    };
    return {.values = own_->ask(is_valid, asking.spent())};
  }
  void tell(const ExecutedTest& test, double /*spent*/) override {
    own_->tell(test.input.values, test.fitness, test.failed);
  }

 private:
  std::unique_ptr<InputGenerator> own_;
};

}  // namespace

std::shared_ptr<const SutModel> model_of(SystemUnderTest system) {
  return std::make_shared<const CustomModel>(std::move(system));
}

GeneratorKind kind_of(const CustomGenerator& generator) {
  return {.name = generator.name,
          .summary = "a generator of the program",
          .parameters = {},
          .make = [make = generator.make](const GeneratorSetup& setup) {
            return std::make_unique<CustomAsking>(make(setup.space.dimension(), setup.seed));
          }};
}

}  // namespace jaywalk::search
