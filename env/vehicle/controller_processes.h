#pragma once

// Processes of external controllers that drive in many tests, one after another: starting one takes
// longer than most tests do. Whoever runs the tests owns them; they belong to one thread.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "env/process/numbered_process.h"

namespace jaywalk {

class ControllerProcesses {
 public:
  /// The one of that command, which is started when it is first asked.
  [[nodiscard]] NumberedProcess& of(const std::vector<std::string>& command);

 private:
  std::map<std::vector<std::string>, std::unique_ptr<NumberedProcess>> processes_;
};

/// As both kinds of controllers start theirs.
[[nodiscard]] std::unique_ptr<NumberedProcess> controller_process(
    const std::vector<std::string>& command);

}  // namespace jaywalk
