// SPDX-License-Identifier: Apache-2.0
#pragma once

// The arithmetic functions of functions.def.

#include "interpreter/logic/action.h"

namespace jaywalk::functions {

#define JAYWALK_FUNCTION(function, least, most, signature, summary) \
  bool function(std::span<const Value> args, Heap& heap, SymbolTable& symbols, Value& result);
#include "interpreter/actions/functions.def"

}  // namespace jaywalk::functions
