#pragma once

// Declares the function that each generator's file defines, from the table.

#include "search/generator.h"

namespace jaywalk::search::generator {
#define JAYWALK_GENERATOR(identifier, name, summary)            \
  namespace identifier {                                        \
  std::span<const NumberParameter> parameters();                \
  std::unique_ptr<Generator> make(const GeneratorSetup& setup); \
  }
#include "search/generators.def"
#undef JAYWALK_GENERATOR
}  // namespace jaywalk::search::generator
