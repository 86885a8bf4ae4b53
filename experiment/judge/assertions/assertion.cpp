// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/assertions/assertion.h"

#include <algorithm>
#include <array>
#include <limits>

#include "experiment/judge/assertions/robustness.h"

namespace jaywalk {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// A test's signals as expressions ask for them.
class RecordedTrace final : public stl::Trace {
 public:
  explicit RecordedTrace(const TestView& view) : view_(view) {}

  [[nodiscard]] std::size_t ticks() const override { return view_.ticks(); }
  [[nodiscard]] double tick_s() const override { return view_.tick_s(); }
  [[nodiscard]] double tolerance() const override { return view_.recording().tolerance(); }
  [[nodiscard]] std::span<const std::uint32_t> road_users() const override {
    return view_.road_users();
  }

  [[nodiscard]] std::span<const double> signal(const stl::Node& node,
                                               std::uint32_t self) const override {
    const auto id = static_cast<SignalId>(node.signal);
    if (node.owner == stl::Owner::nearest) return nearest(id);
    if (node.owner == stl::Owner::named) return view_.values(id, *find(node.name));
    return view_.values(id, self);
  }

  [[nodiscard]] std::span<const double> event(const stl::Node& node,
                                              std::uint32_t self) const override {
    const auto [entry, missing] = events_.try_emplace({node.name, self});
    if (missing) {
      entry->second.assign(ticks(), 0);
      for (const RecordedEvent& event : view_.recording().events()) {
        if (event.kind != node.name || event.actor.value_or(self) != self) continue;
        if (event.tick < ticks()) entry->second[event.tick] = 1;
      }
    }
    return entry->second;
  }

  /// Whether all actors that the expression names take part in the test.
  [[nodiscard]] bool has_actors_of(const stl::Expression& expression) const {
    return std::ranges::all_of(expression.nodes, [&](const stl::Node& node) {
      if (node.kind != stl::NodeKind::signal) return true;
      if (node.owner == stl::Owner::nearest) return !road_users().empty();
      return node.owner != stl::Owner::named || find(node.name).has_value();
    });
  }

 private:
  [[nodiscard]] std::optional<ActorIndex> find(const std::string& name) const {
    for (const ActorIndex user : view_.road_users()) {
      if (view_.recording().actors()[user].name == name) return user;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::span<const double> nearest(SignalId id) const {
    const auto [entry, missing] = nearest_.try_emplace(id);
    if (missing) {
      const auto who = view_.nearest();
      for (std::size_t tick = 0; tick < ticks(); ++tick) {
        entry->second.push_back(view_.values(id, who[tick])[tick]);
      }
    }
    return entry->second;
  }

  const TestView& view_;
  mutable std::map<std::pair<std::string, std::uint32_t>, std::vector<double>> events_;
  mutable std::map<SignalId, std::vector<double>> nearest_;
};

stl::Truth at_begin(const stl::Expression& expression, const stl::Trace& trace, ActorIndex self) {
  return stl::evaluate(expression, expression.root, trace, self).front();
}

/// The assertion's judgement for one road user, or for the AV alone.
Judgement judge_one(const Assertion& assertion, const RecordedTrace& trace, ActorIndex self) {
  Judgement result;
  const stl::Truth precondition = at_begin(assertion.precondition, trace, self);
  result.exercised = precondition.robustness;
  if (!precondition.holds) return result;
  const stl::Truth requirement = at_begin(assertion.requirement, trace, self);
  result.robustness = requirement.robustness;
  result.excused = assertion.unavoidable && at_begin(*assertion.unavoidable, trace, self).holds;
  result.verdict = Verdict::pass;
  if (!requirement.holds) {
    result.verdict = result.excused ? Verdict::unavoidable : Verdict::fail;
    result.tick = static_cast<std::uint32_t>(
        stl::first_violation(assertion.requirement, assertion.requirement.root, trace, self, 0));
  }
  if (assertion.is_about_one()) result.witnesses = {self};
  return result;
}

int gravity(Verdict verdict) {
  switch (verdict) {
    case Verdict::vacuous:
      return 0;
    case Verdict::pass:
      return 1;
    case Verdict::unavoidable:
      return 2;
    case Verdict::fail:
      return 3;
  }
  return 0;
}

/// Takes the judgement of another road user into the test's.
void merge(Judgement& whole, Judgement one) {
  whole.exercised = std::max(whole.exercised, one.exercised);
  if (one.verdict == Verdict::vacuous) return;
  if (whole.robustness) one.robustness = std::min(*whole.robustness, *one.robustness);
  whole.robustness = one.robustness;
  whole.excused = whole.excused || one.excused;
  if (gravity(one.verdict) < gravity(whole.verdict)) return;
  if (gravity(one.verdict) > gravity(whole.verdict)) {
    whole.verdict = one.verdict;
    whole.tick = one.tick;
    whole.witnesses = std::move(one.witnesses);
    return;
  }
  if (one.tick) whole.tick = std::min(*one.tick, whole.tick.value_or(*one.tick));
  whole.witnesses.insert(whole.witnesses.end(), one.witnesses.begin(), one.witnesses.end());
}

}  // namespace

std::string_view name(AssertionSeverity severity) {
  static constexpr std::array<std::string_view, 3> kNames = {"minor", "major", "critical"};
  return kNames[static_cast<std::size_t>(severity)];
}

std::string_view name(Verdict verdict) {
  static constexpr std::array<std::string_view, kVerdictCount> kNames = {"vacuous", "pass", "fail",
                                                                         "unavoidable"};
  return kNames[static_cast<std::size_t>(verdict)];
}

bool Assertion::is_about_one() const {
  return precondition.is_about_one() || requirement.is_about_one() ||
         (unavoidable && unavoidable->is_about_one());
}

Judgement judge(const Assertion& assertion, const TestView& view) {
  const RecordedTrace trace(view);
  Judgement result{.exercised = -kInf};
  const bool possible = trace.has_actors_of(assertion.precondition) &&
                        trace.has_actors_of(assertion.requirement) &&
                        (!assertion.unavoidable || trace.has_actors_of(*assertion.unavoidable));
  if (!possible) return result;
  if (!assertion.is_about_one()) return judge_one(assertion, trace, kAv);
  for (const ActorIndex user : view.road_users()) {
    merge(result, judge_one(assertion, trace, user));
  }
  return result;
}

const stl::Vocabulary& signal_vocabulary() {
  static const std::vector<stl::SignalName> names = [] {
    constexpr std::array kOwners = {stl::Owner::test, stl::Owner::av, stl::Owner::self};
    std::vector<stl::SignalName> result;
    for (const Signal& signal : signals()) {
      // The dot of `av.speed` belongs to the syntax.
      std::string_view plain = signal.name;
      if (signal.owner == SignalOwner::av) plain.remove_prefix(std::string_view("av.").size());
      result.push_back({plain, kOwners[static_cast<std::size_t>(signal.owner)],
                        signal.kind == SignalKind::number ? stl::SignalType::number
                                                          : stl::SignalType::condition});
    }
    return result;
  }();
  static const stl::Vocabulary vocabulary(names);
  return vocabulary;
}

}  // namespace jaywalk
