// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/actions/java/java_regex.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::actions {
namespace {

constexpr std::size_t kMaxFiles = 1'000'000;
constexpr int kMaxFolderDepth = 100;

// Links to folders are not followed, and what cannot be read is passed over.
// `problem`: why a name could not be matched, if one could not.
void find_files(const std::filesystem::path& folder, const Regex& pattern, int depth,
                std::vector<std::string>& found, std::string& problem) {
  std::error_code error;
  std::vector<std::filesystem::path> entries;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    entries.push_back(entry->path());
  }
  std::sort(entries.begin(), entries.end());
  for (const std::filesystem::path& path : entries) {
    if (found.size() >= kMaxFiles) return;
    const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
    if (!error && std::filesystem::is_directory(status)) {
      if (depth < kMaxFolderDepth) find_files(path, pattern, depth + 1, found, problem);
    } else if (std::filesystem::is_regular_file(path, error)) {
      std::string why;
      if (pattern.matches(path.filename().string(), why)) found.push_back(path.string());
      if (!why.empty()) problem = fmt::format("left out {}: {}", path.string(), why);
    }
  }
}

std::string why_unreadable(const std::string& folder) {
  std::error_code error;
  const std::filesystem::directory_iterator opened(folder, error);
  return error ? fmt::format("cannot list {}: {}", folder, error.message()) : std::string();
}

}  // namespace

Outcome list_files(ActionCall& call) {
  const std::size_t result = call.count() - 1;
  for (std::size_t i = 0; i < result; ++i) {
    if (!call.arg(i).is_text()) return call.wrong_argument(i, "a string");
  }
  std::string error;
  const std::optional<Regex> pattern =
      Regex::parse(result == 2 ? call.arg(1).text()->view() : std::string_view(".*"), error);
  if (!pattern) return call.java_exception(error);
  const std::string folder(call.arg(0).text()->view());
  std::vector<std::string> found;
  std::string problem = call.agent()->host().society().why_not_list(folder);
  if (problem.empty()) problem = why_unreadable(folder);
  // As in Jason such a folder has no files, and the plan goes on.
  if (problem.empty()) find_files(folder, *pattern, 0, found, problem);
  if (!problem.empty()) call.agent()->log(problem);
  std::vector<Value> files;
  for (const std::string& file : found) files.push_back(call.heap().text(file));
  return call.result(result, call.heap().list(files));
}

}  // namespace jaywalk::actions
