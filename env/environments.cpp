#include "env/environments.h"

#include <algorithm>
#include <array>

#include "env/crossing/vocabulary.h"

namespace jaywalk {

std::span<const EnvironmentKind> environments() {
#define JAYWALK_ENVIRONMENT(name, summary, percepts, actions) \
  EnvironmentKind{name, summary, percepts, actions},
  static constexpr std::array kEnvironments{
#include "env/environments.def"
  };
#undef JAYWALK_ENVIRONMENT
  return kEnvironments;
}

const EnvironmentKind* find_environment(std::string_view name) {
  const std::span<const EnvironmentKind> all = environments();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const EnvironmentKind& kind) { return kind.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string_view functor(const EnvironmentWord& word) {
  return word.form.substr(0, word.form.find('('));
}

int arity(const EnvironmentWord& word) {
  if (word.form.find('(') == std::string_view::npos) return 0;
  return 1 + static_cast<int>(std::count(word.form.begin(), word.form.end(), ','));
}

}  // namespace jaywalk
