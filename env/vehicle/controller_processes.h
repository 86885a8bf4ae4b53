// SPDX-License-Identifier: Apache-2.0
#pragma once

// Processes of external controllers (external.cpp describes the protocol). The runner of the tests
// keeps a process that drives in many tests, one after another, since starting it takes longer than
// most tests do; it belongs to one thread.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/process/numbered_process.h"
#include "env/vehicle/vehicle.h"
#include "env/vehicle/view_text.h"

namespace jaywalk {

/// A controller's answers in drives that began alike: most defects leave its views unchanged for
/// much of a test, and many for all of it. A controller that receives the same views in the same
/// order gives the same answers, so it need not be queried again. Drives are a tree: each step has
/// a view and its answer, and leads to those that came next.
class KnownDrives {
 public:
  struct Step {
    std::string view;
    double answer = 0;
  };

  KnownDrives() { forget(); }

  void forget();
  /// Goes to where all drives begin.
  void begin() { at_ = 0; }
  /// Goes on by that view and returns its answer; stays where it is if no drive went so.
  std::optional<double> follow(const std::string& view);
  /// Goes on by a step that is new. Beyond 64 MB no more is kept.
  void add(Step step);
  /// Step by step from the begin to here.
  struct Way {
    std::vector<std::string> views;
    std::vector<double> answers;
  };
  [[nodiscard]] Way way_here() const;

 private:
  /// Others are known by their index; 0 is where drives begin and stands for none.
  struct Node {
    Step step;
    std::size_t before = 0;
    std::size_t next = 0;     // the last of those that come next
    std::size_t sibling = 0;  // another one that comes next to the same
  };

  std::vector<Node> nodes_;
  std::size_t at_ = 0;
  std::size_t bytes_ = 0;
  bool full_ = false;
};

/// Errors are texts for people, empty if all is well. After one the process is gone; the next drive
/// starts it anew.
class ControllerProcess {
 public:
  explicit ControllerProcess(const std::vector<std::string>& command);

  /// Begins a drive of a kept process. If it repeats the drive before, nothing is sent until a view
  /// comes that was not seen in that drive; then all earlier views are sent again.
  [[nodiscard]] std::string begin(nlohmann::json reset);
  /// Its answer: an acceleration in m/s^2, not yet limited to what a vehicle can do.
  [[nodiscard]] std::string decide(const VehicleView& view, std::uint64_t test,
                                   double& acceleration_mps2);
  [[nodiscard]] std::string end(nlohmann::json end);
  /// Like the functions of LineProcess.
  void finish() { process_.finish(); }
  [[nodiscard]] std::string take_errors() { return process_.take_errors(); }

 private:
  [[nodiscard]] std::string say_reset();
  [[nodiscard]] std::string catch_up();
  [[nodiscard]] std::string ask(const std::string& view, double& acceleration_mps2);
  [[nodiscard]] std::string read_acceleration(const JsonAnswer& answer, double& acceleration_mps2);
  [[nodiscard]] std::string read_fields(const nlohmann::json& answer);
  /// Resets the state of a process that has ended.
  [[nodiscard]] std::string failed(std::string why);

  NumberedProcess process_;
  nlohmann::json reset_;  // of the drive that it is in; null if it is not kept
  ViewFields fields_;     // those that it reads
  KnownDrives drives_;
  bool follows_ = false;  // all of this drive's views are known, and none has been sent
  std::size_t step_ = 0;
};

class ControllerProcesses {
 public:
  /// The one of that command, which is started when it is first asked.
  [[nodiscard]] ControllerProcess& of(const std::vector<std::string>& command);

 private:
  std::map<std::vector<std::string>, std::unique_ptr<ControllerProcess>> processes_;
};

}  // namespace jaywalk
