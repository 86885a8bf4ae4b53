// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/program_file.h"

#include <fstream>
#include <sstream>
#include <string_view>

namespace jaywalk::test {
namespace {

constexpr std::uint64_t kCycles = 20'000;
constexpr std::uint64_t kTicks = 50;

/// Removes `prefix` from `line`; false if it does not begin so.
bool take(std::string_view& line, std::string_view prefix) {
  if (!line.starts_with(prefix)) return false;
  line.remove_prefix(prefix.size());
  return true;
}

bool read_limit(std::string_view text, MasOptions& options) {
  std::istringstream words{std::string(text)};
  std::string name;
  std::uint64_t number = 0;
  if (!(words >> name >> number)) return false;
  if (name == "cycles") {
    options.max_cycles = number;
  } else if (name == "ticks") {
    options.max_ticks = number;
  } else if (name == "inferences") {
    options.max_inferences = number;
  } else if (name == "heap") {
    options.max_agent_bytes = number;
  } else {
    return false;
  }
  return true;
}

bool read_expectation(std::string_view text, ProgramFile& file) {
  if (take(text, ":")) {
    take(text, " ");
    file.printed["agent"].emplace_back(text);
  } else if (take(text, " [")) {
    const std::size_t end = text.find("]:");
    if (end == text.npos) return false;
    std::vector<std::string>& lines = file.printed[std::string(text.substr(0, end))];
    text.remove_prefix(end + 2);
    take(text, " ");
    lines.emplace_back(text);
  } else if (take(text, " error ")) {
    file.errors.emplace_back(text);
  } else if (take(text, " log: ")) {
    file.logged.emplace_back(text);
  } else if (take(text, " end: ")) {
    file.end = text;
  } else {
    return false;
  }
  return true;
}

// The options of a project that have a meaning here, as in a `.mas2j`.
bool read_settings(std::string_view text, ReasoningSettings& settings) {
  std::istringstream words{std::string(text)};
  std::string word;
  while (words >> word) {
    std::string_view value = word;
    if (take(value, "nrcbp=")) {
      settings.cycles_per_look = static_cast<std::uint32_t>(std::stoul(std::string(value)));
    } else if (word == "events=requeue") {
      settings.unwanted = ReasoningSettings::Unwanted::requeue;
    } else if (word == "intBels=newFocus") {
      settings.same_focus = false;
    } else if (word == "tro=false") {
      settings.tail_recursion = false;
    } else if (word == "synchronised=true") {
      settings.messages_by_plans = true;
    } else {
      return false;
    }
  }
  return true;
}

/// False: the comment begins like one of ours but is none.
bool read_comment(std::string_view comment, ProgramFile& file) {
  if (take(comment, "expect")) return read_expectation(comment, file);
  if (take(comment, "limit ")) return read_limit(comment, file.options);
  if (take(comment, "settings: ")) return read_settings(comment, file.agents.back().settings);
  if (take(comment, "environment: ")) {
    file.on_board = comment == "board";
    return file.on_board;
  }
  return true;
}

}  // namespace

ProgramFile read_program_file(const std::string& path) {
  ProgramFile file;
  file.options.max_cycles = kCycles;
  file.options.max_ticks = kTicks;
  std::ifstream stream(path);
  if (!stream) file.problems.push_back("cannot read " + path);
  file.agents.push_back({"agent", "", {}});
  std::string line;
  std::string* included = nullptr;  // the file whose lines these are; null: an agent's
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    std::string_view text = line;
    if (take(text, "// file ")) {
      included = &file.files[std::string(text)];
    } else if (take(text, "// agent ")) {
      included = nullptr;
      if (number == 1) file.agents.clear();
      // Lines keep their numbers.
      file.agents.push_back({std::string(text), std::string(number - 1, '\n'), {}});
    } else {
      const std::size_t comment = text.find("// ");
      if (comment != text.npos && !read_comment(text.substr(comment + 3), file)) {
        file.problems.push_back("line " + std::to_string(number) + " is not understood: " + line);
      }
    }
    (included != nullptr ? *included : file.agents.back().text) += line + "\n";
  }
  if (file.agents.size() > 1 && file.agents.front().name == "agent") {
    file.agents.erase(file.agents.begin());  // only comments stand before the first agent
  }
  return file;
}

}  // namespace jaywalk::test
