// SPDX-License-Identifier: Apache-2.0
#pragma once

// Traces from numbers, so that tests of expressions need no recording.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiment/judge/assertions/robustness.h"

namespace jaywalk::stl {

/// Signals `x` and `y` of road users, `av.v` of the vehicle, the condition `p`, and `time`.
inline const std::vector<SignalName> kTestSignals = {
    {"x", Owner::self, SignalType::number},    {"y", Owner::self, SignalType::number},
    {"p", Owner::self, SignalType::condition}, {"v", Owner::av, SignalType::number},
    {"time", Owner::test, SignalType::number},
};

class TestTrace final : public Trace {
 public:
  TestTrace(std::size_t ticks, double tick_s, std::uint32_t users)
      : ticks_(ticks), tick_s_(tick_s) {
    for (std::uint32_t user = 1; user <= users; ++user) users_.push_back(user);
    none_.assign(ticks, 0);
  }
  /// Signal by its number in kTestSignals.
  void set(std::uint32_t signal, std::uint32_t user, std::vector<double> values) {
    values_[{signal, user}] = std::move(values);
  }
  void set_event(const std::string& kind, std::uint32_t user, std::vector<double> values) {
    events_[{kind, user}] = std::move(values);
  }

  [[nodiscard]] std::size_t ticks() const override { return ticks_; }
  [[nodiscard]] double tick_s() const override { return tick_s_; }
  [[nodiscard]] std::span<const std::uint32_t> road_users() const override { return users_; }
  [[nodiscard]] std::span<const double> signal(const Node& node,
                                               std::uint32_t self) const override {
    const bool own = node.owner == Owner::self;
    std::uint32_t user = own ? self : 0;
    if (node.owner == Owner::named) user = static_cast<std::uint32_t>(node.name.back() - '0');
    const auto found = values_.find({node.signal, user});
    return found == values_.end() ? none_ : found->second;
  }
  [[nodiscard]] std::span<const double> event(const Node& node, std::uint32_t self) const override {
    const auto found = events_.find({node.name, self});
    return found == events_.end() ? none_ : found->second;
  }

 private:
  std::size_t ticks_;
  double tick_s_;
  std::vector<std::uint32_t> users_;
  std::vector<double> none_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<double>> values_;
  std::map<std::pair<std::string, std::uint32_t>, std::vector<double>> events_;
};

/// The parsed and resolved text; diagnostics, if any, are rendered into `errors`.
inline std::optional<Expression> expression(const std::string& text, std::string* errors = nullptr,
                                            const std::map<std::string, double>& parameters = {}) {
  Diagnostics diagnostics;
  auto parsed =
      parse(expression_text(std::make_shared<const Source>("rules.yaml", text)), diagnostics);
  std::optional<Expression> resolved;
  if (parsed) {
    resolved = resolve(std::move(*parsed), Vocabulary(kTestSignals), parameters, diagnostics);
  }
  if (errors != nullptr) *errors = diagnostics.render();
  return resolved;
}

}  // namespace jaywalk::stl
