// SPDX-License-Identifier: Apache-2.0
// `jaywalk` has no pictures of its own: replay_pictures.h.

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "tools/jaywalk/commands/replay_pictures.h"

namespace jaywalk {
namespace {

/// The words that this process was started with.
std::vector<std::string> own_words() {
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(stream, word, '\0');) words.push_back(word);
  return words;
}

}  // namespace

ExitCode write_pictures(const ResultsReader&, const StoredTest&, const ReplayWishes&,
                        const Arguments&, Console& console) {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string drawer = (self.parent_path() / "jaywalk-draw").string();
  std::vector<std::string> words = own_words();
  if (words.empty()) {
    console.error("pictures are drawn by another program, which is found by /proc",
                  "mount /proc, or write a page with --html");
    return ExitCode::failed;
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(drawer.c_str(), arguments.data());
  console.error(fmt::format("cannot run '{}': {}", drawer, std::strerror(errno)),
                "it draws the pictures, and is installed beside jaywalk");
  return ExitCode::failed;
}

}  // namespace jaywalk
