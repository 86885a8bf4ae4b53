// SPDX-License-Identifier: Apache-2.0
#pragma once

// A small program that is run while an observer looks.

#include <string>
#include <vector>

#include "interpreter/coverage/source_coverage.h"
#include "tests/unit/mas/system.h"

namespace jaywalk::test {

struct Observed {
  explicit Observed(const std::string& program, Probes::Detail detail = Probes::Detail::counts)
      : source(std::make_shared<const Source>("agent.asl", program)) {
    system.add("agent", program);
    probes = std::make_unique<Probes>(system.symbols, detail);
    probes->add(system.agents.front().program);
    texts = find_texts(*probes, std::vector{source});
  }

  /// Runs the program to its end; what it printed is in `system`.
  RunOutcome run(ReasoningObserver& observer) {
    system.options.observer = &observer;
    return system.run();
  }

  System system;
  SourcePtr source;
  std::unique_ptr<Probes> probes;
  ProbeTexts texts;
};

}  // namespace jaywalk::test
