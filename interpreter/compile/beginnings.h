#pragma once

#include <vector>

#include "interpreter/program/program.h"

namespace jaywalk {

/// What the agents of a program begin to believe, predicate by predicate; rows are shared of those
/// that no plan hears of. REQUIRES: its beliefs, rule tables and plans are complete; `constants` is
/// its heap.
[[nodiscard]] std::vector<Program::Beginning> beginnings_of(const Program& program, Heap& constants,
                                                            SymbolTable& symbols);

}  // namespace jaywalk
