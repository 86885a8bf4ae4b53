// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/files/write_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "experiment/scenario/files/temporary.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

std::string reason() { return std::generic_category().message(errno); }

/// Closes without looking at the outcome; write_text closes by hand where that matters.
struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::optional<std::string> write_text(const std::string& path, const TextSource& source) {
  std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "wb"));
  if (!file) return reason();
  std::optional<std::string> failure;
  const bool whole = source([&](std::string_view piece) {
    if (failure || std::fwrite(piece.data(), 1, piece.size(), file.get()) == piece.size()) return;
    failure = reason();
  });
  if (failure) return failure;
  if (!whole) return std::string();
  if (std::fclose(file.release()) != 0) return reason();
  return std::nullopt;
}

std::string folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace

std::string replaced_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return {};
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  if (path.starts_with("/dev/") || path.starts_with("/proc/")) return {};
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

std::string output_path(const std::string& folder, std::string_view name) {
  std::string file(name);
  for (char& c : file) {
    if (!is_name_character(c) && c != '-' && c != '.') c = '_';
  }
  if (file.starts_with('.')) file[0] = '_';
  return folder + '/' + (file.empty() ? "_" : file);
}

std::optional<std::string> write_file(const std::string& path, std::string_view text, Links links) {
  return write_file(
      path,
      [text](const TextSink& sink) {
        sink(text);
        return true;
      },
      links);
}

std::optional<std::string> write_file(const std::string& path, const TextSource& source,
                                      Links links) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const bool follows = links == Links::followed;
  const auto status = follows ? fs::status(path, ignored) : fs::symlink_status(path, ignored);
  if (fs::is_directory(status)) return "it is a folder";
  const std::string replaced = follows ? replaced_file(path) : path;
  if (replaced.empty()) return write_text(path, source);

  PartFile part(replaced);
  if (!part.is_open()) return reason();
  auto failure = write_text(part.name(), source);
  if (!failure && !part.replace()) failure = reason();
  return failure;
}

std::optional<std::string> why_not_writable(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (fs::is_directory(status)) return "it is a folder";
  const std::string replaced = replaced_file(path);
  if (replaced.empty()) {
    return ::access(path.c_str(), W_OK) == 0 ? std::nullopt : std::optional(reason());
  }
  const std::string folder = folder_of(replaced);
  if (!fs::exists(folder, ignored)) return fmt::format("there is no folder '{}'", folder);
  const PartFile part(replaced);
  return part.is_open() ? std::nullopt : std::optional(reason());
}

std::optional<std::string> why_no_folder(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path there = fs::path(path).lexically_normal();
  while (!there.empty() && !fs::exists(there, ignored)) there = there.parent_path();
  if (there.empty()) there = ".";
  if (!fs::is_directory(there, ignored)) {
    return fmt::format("'{}' is no folder", there.string());
  }
  return why_not_writable((there / "probe").string());
}

}  // namespace jaywalk
