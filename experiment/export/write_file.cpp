#include "experiment/export/write_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::string reason() { return std::generic_category().message(errno); }

/// Closes without looking at the outcome; write_text closes by hand where that matters.
struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::optional<std::string> write_text(const std::string& path, std::string_view text) {
  std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "wb"));
  if (!file) return reason();
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) return reason();
  if (std::fclose(file.release()) != 0) return reason();
  return std::nullopt;
}

}  // namespace

std::optional<std::string> write_file(const std::string& path, std::string_view text) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return "it is a folder";
  const bool regular = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
  if (!regular) return write_text(path, text);

  const std::string temporary = fmt::format("{}.{}.part", path, ::getpid());
  auto failure = write_text(temporary, text);
  if (!failure && std::rename(temporary.c_str(), path.c_str()) != 0) failure = reason();
  if (failure) std::filesystem::remove(temporary, ignored);
  return failure;
}

}  // namespace jaywalk
