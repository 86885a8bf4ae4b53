// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jaywalk {

class Agent;
class Intention;
struct Step;

/// A formula that an intention is about to execute, with the values that its variables have by now.
/// Empty if it was not written in a program.
[[nodiscard]] std::string formula_with_values(Agent& agent, const Intention& intention,
                                              const Step& step);

}  // namespace jaywalk
