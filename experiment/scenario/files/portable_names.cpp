// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/files/portable_names.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

/// `/home/me/` of `/home/me/a/b.asl`.
std::string first_folders(const std::string& path) {
  const std::size_t second = path.find('/', 1);
  const std::size_t third = second == std::string::npos ? second : path.find('/', second + 1);
  return third == std::string::npos ? folder_of(path) : path.substr(0, third + 1);
}

}  // namespace

PortableNames::PortableNames(const std::vector<std::string>& names, const SourceFiles& files) {
  const std::string installed = files.installed_folder();
  if (!installed.empty()) roots_.push_back(installed);
  std::map<std::string, std::string> common;  // by the first two folders
  for (const std::string& name : names) {
    if (!fs::path(name).is_absolute()) continue;
    if (!installed.empty() && name.starts_with(installed)) continue;
    const auto [root, is_new] = common.try_emplace(first_folders(name), folder_of(name));
    while (!name.starts_with(root->second)) {
      root->second = folder_of(root->second.substr(0, root->second.size() - 1));
    }
  }
  for (const auto& [folders, root] : common) roots_.push_back(root);
  // Two files must not become one.
  const std::set<std::string> before(names.begin(), names.end());
  std::set<std::string> after;
  for (const std::string& name : before) after.insert(in(name));
  if (after.size() < before.size()) roots_.clear();
}

std::string PortableNames::in(std::string text) const {
  for (const std::string& root : roots_) {
    for (std::size_t at = text.find(root); at != std::string::npos; at = text.find(root, at)) {
      text.erase(at, root.size());
    }
  }
  return text;
}

std::string portable_path(const std::string& path) { return PortableNames({path}, {}).in(path); }

}  // namespace jaywalk
