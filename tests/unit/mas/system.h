// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small systems for tests: agents from texts, what they print, and a world of one number.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/mas/mas.h"
#include "interpreter/term/symbol.h"

namespace jaywalk::test {

struct System {
  explicit System(MasOptions with = {});

  /// REQUIRES: the text is a program.
  void add(const std::string& name, std::string_view text);
  /// What `.create_agent` finds under a file name.
  void provide(const std::string& file, std::string_view text) { files[file] = text; }
  RunOutcome run(Environment* environment = nullptr);

  std::shared_ptr<SymbolTable> symbols = std::make_shared<SymbolTable>();
  MasOptions options;
  std::vector<AgentSpec> agents;
  std::map<std::string, std::string> files;
  std::vector<std::string> printed;
  std::vector<std::string> logged;
  std::unique_ptr<Mas> mas;
};

/// Every agent perceives `tick(N)`. The action `refuse` fails, all others succeed.
class TestWorld : public Environment {
 public:
  TestWorld(SymbolTable& symbols, int last_tick)
      : tick_(symbols.predicate("tick", 1)),
        refuse_(symbols.predicate("refuse", 0)),
        symbols_(symbols),
        last_tick_(last_tick) {}

  void perceive(AgentId agent, Percepts& percepts) const override;
  void execute(std::span<const ActionRequest> actions, std::span<ActionResult> results) override;
  void advance() override { ++now_; }
  [[nodiscard]] bool finished() const override { return now_ > last_tick_; }
  [[nodiscard]] double tick_ms() const override { return 100; }

  /// The actions of each tick: "0:go 1:stay".
  std::vector<std::string> history;

 private:
  Predicate tick_;
  Predicate refuse_;
  SymbolTable& symbols_;
  int now_ = 0;
  int last_tick_;
};

}  // namespace jaywalk::test
