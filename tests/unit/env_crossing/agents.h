// SPDX-License-Identifier: Apache-2.0
#pragma once

// Agents of the crossing world, their percepts as text, and the results of their actions.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "env/crossing/crossing.h"
#include "interpreter/term/print.h"

namespace jaywalk {

class CrossingAgents : public testing::Test {
 protected:
  Crossing world(std::vector<Position> start) const {
    return Crossing(parameters_, vocabulary_, std::move(start));
  }

  /// An agent's percepts with a functor: `kerb(right,2) kerb(left,1)`, in their order.
  std::string seen(const Crossing& crossing, std::size_t agent, std::string_view functor) const {
    Percepts percepts;
    crossing.perceive(static_cast<AgentId>(agent), percepts);
    std::string text;
    for (std::size_t i = 0; i < percepts.size(); ++i) {
      if (symbols_.functor(percepts.predicate(i)) != functor) continue;
      std::string args;
      for (const Value value : percepts.args(i)) {
        args += (args.empty() ? "" : ",") + term_text(value, symbols_);
      }
      text += fmt::format("{}{}({})", text.empty() ? "" : " ", functor, args);
    }
    return text;
  }

  /// An action of an agent with arguments.
  struct Action {
    std::size_t agent = 0;
    Predicate predicate{};
    std::vector<Value> args;
  };
  Action move(std::size_t agent, Direction way) const {
    return {agent, vocabulary_.move(), {vocabulary_.atom(way)}};
  }
  Action move(std::size_t agent, Direction way, double cells) const {
    return {agent, vocabulary_.move_by(), {vocabulary_.atom(way), Value::number(cells)}};
  }
  Action stay(std::size_t agent) const { return {agent, vocabulary_.stay(), {}}; }
  Action show(std::size_t agent, SignalColour colour) const {
    return {agent, vocabulary_.show(), {vocabulary_.atom(colour)}};
  }

  /// One tick; why each action failed, empty if it did not.
  static std::vector<std::string> tick(Crossing& crossing, const std::vector<Action>& actions) {
    std::vector<ActionRequest> requests;
    for (const Action& action : actions) {
      requests.push_back({static_cast<AgentId>(action.agent), action.predicate, action.args});
    }
    std::vector<ActionResult> results(actions.size());
    crossing.execute(requests, results);
    crossing.advance();
    std::vector<std::string> reasons;
    for (const ActionResult& result : results) {
      reasons.push_back(result.succeeded ? "" : result.reason);
    }
    return reasons;
  }

  SymbolTable symbols_;
  CrossingVocabulary vocabulary_{symbols_};
  CrossingParameters parameters_;
};

}  // namespace jaywalk
