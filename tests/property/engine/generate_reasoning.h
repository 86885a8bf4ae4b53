// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/helpers/generate.h"

namespace jaywalk::test {

/// Whether a program has to do with percepts, those of the oracle's world.
enum class Senses { none, some };

/// A well-formed program that gets something done: goals with results, contexts with rules,
/// comparisons and arithmetic, loops, failures that are handled, changes of belief, messages to
/// `a0` and `a1`. Unlike most of random_program's, its goals have plans, its sums have numbers, and
/// it prints what it finds, open variables too.
[[nodiscard]] std::string random_reasoning(Choices& choices, Senses senses = Senses::none);

}  // namespace jaywalk::test
