// SPDX-License-Identifier: Apache-2.0
#include "search/suts/requirements.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "experiment/judge/assertions/robustness.h"
#include "experiment/scenario/expression_node.h"
#include "interpreter/support/markup.h"

namespace jaywalk::search {
namespace {

constexpr std::size_t kMostSignals = 1000;
constexpr std::size_t kMostRequirements = 200;
constexpr NumberRange kSignalValues{-1e9, 1e9};
/// Stands for infinite robustness.
constexpr double kMostRobust = 1e9;
/// Keeps a requirement that was kept from having the robustness of one that was violated, 0.
constexpr double kJustKept = 1e-12;
/// By which share of it a step from one time to the next may differ from the mean step.
constexpr double kUneven = 1e-3;

class ReturnedTrace final : public stl::Trace {
 public:
  explicit ReturnedTrace(std::span<const std::vector<double>> values) : values_(values) {}

  [[nodiscard]] std::size_t ticks() const override { return values_.front().size(); }
  [[nodiscard]] double tick_s() const override {
    const std::vector<double>& times = values_.front();
    return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  }
  [[nodiscard]] std::span<const std::uint32_t> road_users() const override { return {}; }
  [[nodiscard]] std::span<const double> signal(const stl::Node& node,
                                               std::uint32_t /*self*/) const override {
    return values_[node.signal];
  }
  [[nodiscard]] std::span<const double> event(const stl::Node& /*node*/,
                                              std::uint32_t /*self*/) const override {
    return {};  // refused when it is read
  }

 private:
  std::span<const std::vector<double>> values_;
};

Robustness judged(const Requirement& requirement, const stl::Trace& trace) {
  const auto of = [&](const stl::Expression& expression) {
    return stl::evaluate(expression, expression.root, trace, 0).front();
  };
  const stl::Truth truth = of(requirement.condition);
  const double own = std::clamp(truth.robustness, -kMostRobust, kMostRobust);
  const double scaled =
      requirement.scaled ? of(*requirement.scaled).robustness : own / requirement.scale;
  if (truth.holds) return {std::max(own, 0.0), std::clamp(scaled, kJustKept, 1.0)};
  return {std::min(own, -kJustKept), std::clamp(scaled, -1.0, 0.0)};
}

/// Whether an expression that consists of this name alone is a signal.
bool is_signal_name(const std::string& name) {
  Diagnostics ignored;
  const auto parsed =
      stl::parse({.text = name, .source = {}, .offsets = {}, .subject = {}}, ignored);
  return parsed && parsed->nodes.size() == 1 && parsed->nodes[0].kind == stl::NodeKind::signal &&
         parsed->nodes[0].name == name && name.find('.') == std::string::npos;
}

class RequirementReader {
 public:
  RequirementReader(const ConfigReader& reader, SignalRange times, Requirements& requirements)
      : reader_(reader), requirements_(requirements) {
    names_.push_back({.name = kTimeSignal, .owner = stl::Owner::test});
    ranges_.push_back(times);
    for (const ReturnedSignal& signal : requirements.signals) {
      names_.push_back({.name = signal.name, .owner = stl::Owner::test});
      ranges_.push_back(signal.range);
    }
  }

  /// `ID: always[0, 20] speed < 120` or `ID: {requirement: '...', scale: 120}`.
  void read(const ConfigEntry& entry, const std::string& path) {
    if (!is_identifier(entry.key)) {
      reader_.error(entry.origin,
                    fmt::format("'{}' cannot be the name of a requirement", entry.key),
                    std::string(kIdentifierHint));
      return;
    }
    Requirement requirement{.id = entry.key, .condition = {}, .scaled = {}};
    const ConfigNode* text = &entry.value;
    std::optional<double> scale;
    if (entry.value.kind == ConfigNode::Kind::map) {
      text = entry.value.find("requirement");
      const std::vector<ConfigKey> keys{
          {"requirement", [](const ConfigNode&, const std::string&) {}},
          {"scale", [&](const ConfigNode& value, const std::string&) {
             scale = reader_.number(value, {1e-9, kSignalValues.most});
             if (!scale) scale = 1;  // reported
           }}};
      reader_.read_map(entry.value, path, keys);
      if (text == nullptr) {
        reader_.error(entry.value.origin, fmt::format("'{}' has no 'requirement'", path));
        return;
      }
    }
    if (!reader_.text(*text, "a condition, as always[0, 20] speed < 120")) return;
    auto condition = parsed(*text);
    if (!condition) return;
    requirement.condition = std::move(*condition);
    if (scale) {
      requirement.scale = *scale;
    } else {
      Diagnostics found;
      requirement.scaled = search::scaled(requirement.condition, ranges_, found);
      for (const Diagnostic& each : found.items())
        reader_.error(origin_of(each, *text), each.message, unscaled_hint());
      if (!requirement.scaled) return;
    }
    requirements_.all.push_back(std::move(requirement));
  }

 private:
  std::optional<stl::Expression> parsed(const ConfigNode& node) {
    Diagnostics found;
    auto expression = stl::parse(expression_text(node), found);
    if (expression) {
      refuse_road_users(*expression, found);
      expression = stl::resolve(std::move(*expression), stl::Vocabulary(names_), {}, found);
    }
    for (const Diagnostic& each : found.items()) {
      reader_.error(origin_of(each, node), each.message, each.hint);
    }
    return found.has_errors() ? std::nullopt : expression;
  }

  static void refuse_road_users(const stl::Expression& expression, Diagnostics& found) {
    for (const stl::Node& node : expression.nodes) {
      const bool is_about_others = node.kind == stl::NodeKind::event ||
                                   node.kind == stl::NodeKind::for_all ||
                                   node.kind == stl::NodeKind::exists;
      if (!is_about_others) continue;
      expression.written.error(found, node.span, "a program's signals are of no road user",
                               "'forall', 'exists' and 'happens' are for recorded scenarios");
    }
  }

  static ValueOrigin origin_of(const Diagnostic& found, const ConfigNode& node) {
    return found.where.source == nullptr ? node.origin : ValueOrigin{found.where, {}};
  }

  static std::string unscaled_hint() {
    return "give each signal in it a range, signals: {speed: [0, 160]}, or the requirement a "
           "'scale': the robustness that is as good as any";
  }

  const ConfigReader& reader_;
  Requirements& requirements_;
  std::vector<stl::SignalName> names_;
  std::vector<SignalRange> ranges_;
};

}  // namespace

std::vector<Robustness> Requirements::judge(std::span<const std::vector<double>> values) const {
  const ReturnedTrace trace(values);
  std::vector<Robustness> judgements;
  for (const Requirement& each : all) judgements.push_back(judged(each, trace));
  return judgements;
}

std::string why_no_times(std::span<const double> times) {
  if (times.size() < 2) return "'time' has fewer than two values";
  const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double step = times[i] - times[i - 1];
    if (!(step > 0))
      return fmt::format("'time' does not rise from {} to {}", times[i - 1], times[i]);
    if (std::fabs(step - mean) > kUneven * mean) {
      return fmt::format(
          "'time' has steps of {:.6g} s and, from {:.6g} on, of {:.6g} s; they must be equal", mean,
          times[i - 1], step);
    }
  }
  return {};
}

void read_signals(const ConfigNode& node, const ConfigReader& reader, Requirements& requirements) {
  const bool is_list = node.kind == ConfigNode::Kind::list && !node.items.empty();
  const bool is_map = node.kind == ConfigNode::Kind::map && !node.entries.empty();
  if (!is_list && !is_map) {
    return reader.unexpected(node, "names of signals, [speed], or with ranges, {speed: [0, 160]}");
  }
  std::set<std::string> names;
  const auto add = [&](const ValueOrigin& origin, const std::string& name, SignalRange range) {
    if (name == kTimeSignal) {
      reader.error(origin, "'time' is there always: it is the time of each value");
    } else if (!is_signal_name(name)) {
      reader.error(
          origin, fmt::format("'{}' cannot be the name of a signal", name),
          "a letter, then letters, digits and _, and no word of the language of assertions");
    } else if (!names.insert(name).second) {
      reader.error(origin, fmt::format("a second signal '{}'", name));
    } else {
      requirements.signals.push_back({name, range});
    }
  };
  for (const ConfigNode& item : node.items) {
    if (const auto name = reader.text(item, "a name")) add(item.origin, *name, {});
  }
  for (const ConfigEntry& entry : node.entries) {
    const auto range = reader.number_pair(entry.value, kSignalValues);
    // Any range if it is wrong, so that uses of the signal are no mistakes of their own.
    add(entry.origin, entry.key, range ? SignalRange{(*range)[0], (*range)[1]} : SignalRange{0, 1});
  }
  if (requirements.signals.size() > kMostSignals) {
    reader.error(node.origin, fmt::format("more than {} signals", kMostSignals));
  }
}

void read_requirements(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                       SignalRange times, Requirements& requirements) {
  if (node.kind != ConfigNode::Kind::map || node.entries.empty()) {
    return reader.unexpected(node, "names and conditions, as slow: always speed < 120");
  }
  if (node.entries.size() > kMostRequirements) {
    return reader.error(node.origin, fmt::format("more than {} requirements", kMostRequirements));
  }
  RequirementReader each(reader, times, requirements);
  for (const ConfigEntry& entry : node.entries) {
    each.read(entry, fmt::format("{}.{}", path, entry.key));
  }
}

}  // namespace jaywalk::search
