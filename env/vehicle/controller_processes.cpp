// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/controller_processes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/diagnostics.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

// A controller that thinks for longer is taken for dead.
constexpr std::chrono::milliseconds kLimit{5000};
// How long one that does not repeat the step is watched for unexpected lines.
constexpr std::chrono::milliseconds kSettling{1};
// Answers beyond a hundred times gravity are refused; smaller ones are limited.
constexpr double kAbsurdMps2 = 1000;

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

ControllerProcess::ControllerProcess(const std::vector<std::string>& command)
    : process_(
          NumberedProcess::Settings{.command = command, .key = "step", .settling = kSettling}) {}

std::string ControllerProcess::begin(nlohmann::json reset) {
  drives_.begin();
  step_ = 1;  // `reset` was 0
  follows_ = reset == reset_;
  if (follows_) return {};
  drives_.forget();
  reset_ = std::move(reset);
  return say_reset();
}

std::string ControllerProcess::decide(const VehicleView& view, std::uint64_t test,
                                      double& acceleration_mps2) {
  std::string text = view_text(view, test, step_, fields_);
  if (follows_) {
    if (const auto known = drives_.follow(text)) {
      acceleration_mps2 = *known;
      ++step_;
      return {};
    }
    if (std::string why = catch_up(); !why.empty()) return why;
  }
  if (std::string why = ask(text, acceleration_mps2); !why.empty()) return why;
  if (!reset_.is_null()) drives_.add({std::move(text), acceleration_mps2});
  return {};
}

std::string ControllerProcess::end(nlohmann::json end) {
  if (follows_) return {};
  // A kept process is asked again, which finds output that comes later.
  const bool is_kept = !reset_.is_null();
  std::string more = process_.said_more(is_kept ? std::chrono::milliseconds(0) : kSettling);
  if (!more.empty()) return failed(std::move(more));
  if (is_kept) process_.tell({{"end", std::move(end)}}, kLimit);
  return {};
}

std::string ControllerProcess::say_reset() {
  const JsonAnswer answer = process_.ask({{"reset", reset_}}, 0, kLimit);
  return failed(answer.error.empty() ? read_fields(answer.json) : answer.error);
}

/// Sends all earlier views of the drive again. An answer that differs from the first time shows
/// that the controller's answers do not depend on the views alone, which is an error.
std::string ControllerProcess::catch_up() {
  follows_ = false;
  if (std::string why = say_reset(); !why.empty()) return why;
  const KnownDrives::Way way = drives_.way_here();
  const std::vector<JsonAnswer> answers = process_.ask_texts(way.views, 1, kLimit);
  step_ = way.views.size() + 1;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    double answer = 0;
    if (std::string why = read_acceleration(answers[i], answer); !why.empty()) return why;
    if (answer == way.answers[i]) continue;
    return failed(process_.refuse(fmt::format(
        "to view {} since `reset` it answered {:g}, but {:g} in a drive before with the same "
        "views; a "
        "process that is kept has to begin anew with each `reset`, and to leave nothing to chance",
        i + 1, answer, way.answers[i])));
  }
  return {};
}

std::string ControllerProcess::ask(const std::string& view, double& acceleration_mps2) {
  return read_acceleration(process_.ask_text(view, step_++, kLimit), acceleration_mps2);
}

std::string ControllerProcess::read_acceleration(const JsonAnswer& answer,
                                                 double& acceleration_mps2) {
  if (!answer.error.empty()) return failed(answer.error);
  const auto acceleration = answer.json.find("acceleration");
  if (acceleration == answer.json.end() || !acceleration->is_number()) {
    return failed(process_.refuse("expected {\"acceleration\": <m/s^2>}"));
  }
  acceleration_mps2 = acceleration->get<double>();
  // A controller that asks for that reckons wrongly, and its other answers mean nothing either.
  if (std::fabs(acceleration_mps2) <= kAbsurdMps2) return {};
  return failed(process_.refuse(fmt::format(
      "no vehicle reaches {:g} m/s^2, let alone more than {:g}", acceleration_mps2, kAbsurdMps2)));
}

std::string ControllerProcess::read_fields(const nlohmann::json& answer) {
  fields_.clear();
  const auto reads = answer.find("reads");
  if (reads == answer.end()) return {};
  const ViewFields all = all_view_fields();
  const auto is_name = [](const nlohmann::json& each) { return each.is_string(); };
  if (!reads->is_array() || reads->empty() || !std::ranges::all_of(*reads, is_name)) {
    return process_.refuse("expected `reads` to be a list of fields of a view");
  }
  for (const nlohmann::json& each : *reads) {
    const auto& name = each.get_ref<const std::string&>();
    if (std::ranges::find(all, name) == all.end()) {
      const std::string hint = did_you_mean(name, all);
      return process_.refuse(fmt::format("a view has no field '{}'{}{}",
                                         shortened(name, kMostQuoted), hint.empty() ? "" : "; ",
                                         hint));
    }
    fields_.push_back(name);
  }
  return {};
}

std::string ControllerProcess::failed(std::string why) {
  if (!why.empty()) reset_ = nullptr;
  return why;
}

ControllerProcess& ControllerProcesses::of(const std::vector<std::string>& command) {
  std::unique_ptr<ControllerProcess>& process = processes_[command];
  if (!process) process = std::make_unique<ControllerProcess>(command);
  return *process;
}

}  // namespace jaywalk
