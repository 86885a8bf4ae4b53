// SPDX-License-Identifier: Apache-2.0
#include "env/environments.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include "env/world/world_section.h"

namespace jaywalk {

// Each row's function, which is in the world's own folder.
#define JAYWALK_WORLD(name) EnvironmentKind name##_world();
#include "env/environments.def"
#undef JAYWALK_WORLD

namespace {

// "a b" of "Other: x; Name: a b".
std::vector<std::string> words_behind(std::string_view name, std::string_view lists) {
  while (!lists.empty()) {
    std::string_view list = lists.substr(0, lists.find(';'));
    lists.remove_prefix(std::min(lists.size(), list.size() + 1));
    while (list.starts_with(' ')) list.remove_prefix(1);
    if (!list.starts_with(name) || list.substr(name.size(), 1) != ":") continue;
    std::istringstream words{std::string(list.substr(name.size() + 1))};
    return {std::istream_iterator<std::string>(words), {}};
  }
  return {};
}

}  // namespace

std::span<const EnvironmentKind> environments() {
  static const std::array kEnvironments{
#define JAYWALK_WORLD(name) name##_world(),
#include "env/environments.def"
#undef JAYWALK_WORLD
  };
  return kEnvironments;
}

const EnvironmentKind* find_environment(std::string_view name) {
  const std::span<const EnvironmentKind> all = environments();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const EnvironmentKind& kind) { return kind.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::shared_ptr<const WorldSpec> default_world() {
  return environments().front().section()->finish();
}

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const EnvironmentKind& kind : environments()) {
    all.insert(all.end(), kind.presets.begin(), kind.presets.end());
  }
  return all;
}

std::string description(const EnvironmentWord& word) {
  std::string text(word.meaning);
  if (!word.needs.empty()) text += " [needs " + std::string(word.needs) + ']';
  return text;
}

std::string_view functor(const EnvironmentWord& word) {
  return word.form.substr(0, word.form.find('('));
}

int arity(const EnvironmentWord& word) {
  if (word.form.find('(') == std::string_view::npos) return 0;
  return 1 + static_cast<int>(std::count(word.form.begin(), word.form.end(), ','));
}

std::vector<std::vector<std::string>> argument_values(const EnvironmentWord& word) {
  std::vector<std::vector<std::string>> values(static_cast<std::size_t>(arity(word)));
  std::string_view arguments = word.form.substr(functor(word).size());
  for (std::vector<std::string>& own : values) {
    arguments.remove_prefix(1);  // the bracket or comma before it
    const std::string_view argument = arguments.substr(0, arguments.find_first_of(",)"));
    arguments.remove_prefix(argument.size());
    own = words_behind(argument, word.values);
  }
  return values;
}

}  // namespace jaywalk
