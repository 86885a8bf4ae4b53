#include "tools/jaywalk/programs/program_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

bool ends_with_one_of(std::string_view name, std::span<const std::string_view> endings) {
  return std::ranges::any_of(endings, [name](auto ending) { return name.ends_with(ending); });
}

// Adds the folder's files; returns the system's message if that fails.
std::string add_files(const std::string& folder, std::span<const std::string_view> endings,
                      std::vector<std::string>& files) {
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, failure);
  for (const fs::recursive_directory_iterator end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) {
      entry.disable_recursion_pending();
    } else if (ends_with_one_of(name, endings) && entry->is_regular_file(ignored)) {
      files.push_back(entry->path().string());
    }
  }
  return failure ? failure.message() : std::string();
}

}  // namespace

bool expand_folders(std::span<const std::string> operands,
                    std::span<const std::string_view> endings, Console& console,
                    std::vector<std::string>& files) {
  bool all = true;
  for (const std::string& operand : operands) {
    std::error_code ignored;
    if (!fs::is_directory(operand, ignored)) {
      files.push_back(operand);
      continue;
    }
    const std::size_t before = files.size();
    const std::string failure = add_files(operand, endings, files);
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    if (!failure.empty()) {
      console.error(fmt::format("{}: cannot be read: {}", operand, failure));
      all = false;
    } else if (files.size() == before) {
      console.error(fmt::format("{}: no file {} lies there", operand, fmt::join(endings, " or ")));
      all = false;
    }
  }
  return all;
}

}  // namespace jaywalk
