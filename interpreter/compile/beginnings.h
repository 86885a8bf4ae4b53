// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interpreter/program/program.h"

namespace jaywalk {

/// The initial beliefs of a program, grouped by predicate. Agents share the rows of predicates that
/// no plan hears of. A predicate that plans hear of may form several groups, so that its events
/// come in the order of the facts. REQUIRES: its beliefs, rule tables and plans are complete;
/// `constants` is its heap.
[[nodiscard]] std::vector<Program::Beginning> beginnings_of(const Program& program, Heap& constants,
                                                            SymbolTable& symbols);

}  // namespace jaywalk
