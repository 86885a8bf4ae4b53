// SPDX-License-Identifier: Apache-2.0
#pragma once

// Values of configurations as their files would have them, all from the place "here".

#include <string>
#include <utility>
#include <vector>

#include "env/config/reader.h"

namespace jaywalk::test {

inline ConfigNode scalar(std::string text) {
  return {.kind = ConfigNode::Kind::scalar, .text = std::move(text), .origin = {{}, "here"}};
}
inline ConfigNode list(const std::vector<std::string>& texts) {
  ConfigNode node{.kind = ConfigNode::Kind::list, .origin = {{}, "here"}};
  for (const std::string& text : texts) node.items.push_back(scalar(text));
  return node;
}
inline ConfigNode map(std::vector<std::pair<std::string, ConfigNode>> entries) {
  ConfigNode node{.kind = ConfigNode::Kind::map, .origin = {{}, "here"}};
  for (auto& [key, value] : entries) node.entries.push_back({key, {{}, "key " + key}, value});
  return node;
}
inline ConfigNode nothing() { return {.origin = {{}, "here"}}; }

}  // namespace jaywalk::test
