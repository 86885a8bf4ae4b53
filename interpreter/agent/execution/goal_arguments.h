// SPDX-License-Identifier: Apache-2.0
#pragma once

// The arguments of formulas that make events, `!g(X+1)`, `+b`, where they are decoded.

#include "interpreter/program/event_code.h"

namespace jaywalk {

/// Arguments that are variables: how many, and the last of them.
struct OpenArguments {
  std::size_t count = 0;
  Value* last = nullptr;
};

/// Writes the arguments of a formula's literal, a variable without a value as the slot itself.
/// False: the value of some argument is of another kind.
[[gnu::always_inline]] inline bool put_arguments(const EventCode& code, const Value* frame,
                                                 Value* value, OpenArguments& open) {
  for (const Operand& arg : code.args) {
    if (!find_value(arg, frame, *value)) {
      if (arg.kind != Operand::Kind::slot) return false;
      if (value->is_unset()) {
        *value = Value::slot(arg.left_slot);
      } else if (!value->is_variable()) {
        return false;
      }
      ++open.count;
      open.last = value;
    }
    ++value;
  }
  return true;
}

}  // namespace jaywalk
