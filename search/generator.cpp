// SPDX-License-Identifier: Apache-2.0
#include "search/generator.h"

#include <algorithm>
#include <array>

namespace jaywalk::search {

std::span<const GeneratorKind> generators() {
  static const std::array kinds = {
#define JAYWALK_GENERATOR(identifier, name, summary) \
  GeneratorKind{name, summary, generator::identifier::parameters(), generator::identifier::make},
#include "search/generators.def"
#undef JAYWALK_GENERATOR
  };
  return kinds;
}

const GeneratorKind* find_generator(std::string_view name) {
  const auto found = std::ranges::find(generators(), name, &GeneratorKind::name);
  return found == generators().end() ? nullptr : &*found;
}

}  // namespace jaywalk::search
