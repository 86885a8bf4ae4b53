// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/texts.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "interpreter/support/text.h"

namespace jaywalk::fuzz {
namespace {

using Json = nlohmann::json;

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

Texts read_all(std::vector<std::filesystem::path> paths) {
  std::sort(paths.begin(), paths.end());
  Texts texts;
  for (const auto& path : paths) texts.push_back(read_bytes(path));
  return texts;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// The end of the token that begins at `at`, with the blanks after it.
std::size_t token_end(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  const char first = text[at];
  if (is_word(first)) {
    while (end < text.size() && is_word(text[end])) ++end;
  } else if (first == '"') {
    while (end < text.size() && text[end] != '"' && text[end] != '\n') ++end;
    end = std::min(end + 1, text.size());
  } else if (!is_space(first) &&
             std::string_view("()[]{},;.").find(first) == std::string_view::npos) {
    while (end < text.size() &&
           std::string_view("+-!?<>=:&|\\*/").find(text[end]) != std::string_view::npos)
      ++end;
  }
  while (end < text.size() && is_space(text[end])) ++end;
  return end;
}

std::vector<std::string_view> tokens_of(std::string_view text) {
  std::vector<std::string_view> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = token_end(text, at);
    tokens.push_back(text.substr(at, end - at));
    at = end;
  }
  return tokens;
}

/// A run of tokens, by its first and the one behind its last.
struct Run {
  std::size_t first = 0;
  std::size_t end = 0;
};

bool opens(char c) { return c == '(' || c == '[' || c == '{'; }
bool closes(char c) { return c == ')' || c == ']' || c == '}'; }

/// From `first` to the end of the group that begins there.
Run group_at(const std::vector<std::string_view>& tokens, std::size_t first) {
  int depth = 0;
  std::size_t end = first;
  while (end < tokens.size()) {
    const char c = tokens[end++].front();
    if (opens(c)) ++depth;
    if (closes(c)) --depth;
    if (depth <= 0) break;
  }
  return {first, end};
}

/// From behind one full stop to behind another.
Run statements_at(const std::vector<std::string_view>& tokens, std::size_t first) {
  const auto stops = [&](std::size_t i) {
    return tokens[i].front() == '.' && tokens[i].size() > 1;
  };
  while (first > 0 && !stops(first - 1)) --first;
  std::size_t end = first;
  while (end < tokens.size() && !stops(end)) ++end;
  return {first, std::min(end + 1, tokens.size())};
}

Run some_run(Choices& choices, const std::vector<std::string_view>& tokens) {
  const std::size_t first = choices.below(tokens.size());
  switch (choices.below(4)) {
    case 0:
      return {first, first + 1};
    case 1: {
      std::size_t opening = first;
      while (opening < tokens.size() && !opens(tokens[opening].front())) ++opening;
      return group_at(tokens, opening < tokens.size() ? opening : first);
    }
    case 2:
      return statements_at(tokens, first);
    default:
      return {first, std::min(tokens.size(), first + 1 + choices.below(12))};
  }
}

/// The line with another value behind its last colon, dash or comma.
std::string with_value(Choices& choices, const std::string& line, std::string_view value) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ':' || line[i] == '-' || line[i] == ',' || line[i] == '[') places.push_back(i);
  }
  if (places.empty()) return line + std::string(value);
  const std::size_t at = places[choices.below(places.size())] + 1;
  const std::size_t end = std::min(line.find_first_of(",}]", at), line.size());
  return line.substr(0, at) + " " + std::string(value) + line.substr(end);
}

Json odd_json(Choices& choices) {
  switch (choices.below(12)) {
    case 0:
      return nullptr;
    case 1:
      return -1;
    case 2:
      return 2147483648;
    case 3:
      return std::uint64_t{18446744073709551615U};
    case 4:
      return 1e308;
    case 5:
      return -0.5;
    case 6:
      return true;
    case 7:
      return "";
    case 8:
      return std::string(1, '\0');
    case 9:
      return Json::array();
    case 10:
      return Json::object();
    default:
      return Json(
          std::string(choices.one_of({"file:///", "../../x", "\xEF\xBF\xBF", "%00", "{", "1"})));
  }
}

/// Every value of `json` has the chance of one in `rarity` to be replaced or dropped.
void spoil(Choices& choices, Json& json, std::size_t rarity) {
  if (choices.once_in(rarity)) {
    json = odd_json(choices);
    return;
  }
  if (json.is_string() && choices.once_in(rarity)) {
    const std::string text = json.get<std::string>();
    json = test::mutate(choices, text, text);
    return;
  }
  if (!json.is_structured()) return;
  for (auto it = json.begin(); it != json.end();) {
    if (choices.once_in(2 * rarity)) {
      it = json.erase(it);
    } else {
      spoil(choices, *it, rarity);
      ++it;
    }
  }
}

}  // namespace

Texts corpus(std::string_view target) {
  std::vector<std::filesystem::path> paths;
  const std::filesystem::path folder = JAYWALK_SOURCE_DIR "/tests/fuzz/corpus";
  for (const auto& entry : std::filesystem::directory_iterator(folder / target)) {
    paths.push_back(entry.path());
  }
  return read_all(std::move(paths));
}

Texts project_texts(std::string_view folder, std::string_view ending) {
  std::vector<std::filesystem::path> paths;
  const std::filesystem::path root = JAYWALK_SOURCE_DIR;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    if (entry.is_regular_file() && entry.path().string().ends_with(ending)) {
      paths.push_back(entry.path());
    }
  }
  return read_all(std::move(paths));
}

std::string project_text(std::string_view path) {
  return read_bytes(std::filesystem::path(JAYWALK_SOURCE_DIR) / path);
}

std::map<std::string, std::string> walker_files() {
  const std::filesystem::path crossing = JAYWALK_SOURCE_DIR "/agents/crossing";
  std::map<std::string, std::string> files{{"walker.asl", read_bytes(crossing / "proximity.asl")}};
  for (const auto& entry : std::filesystem::directory_iterator(crossing / "shared")) {
    files["shared/" + entry.path().filename().string()] = read_bytes(entry.path());
  }
  return files;
}

const std::string& one_of(Choices& choices, const Texts& texts) {
  return texts[choices.below(texts.size())];
}

std::string splice(Choices& choices, std::string_view text, std::string_view donor) {
  const auto from = tokens_of(donor);
  std::string result(text);
  const std::size_t times = 1 + choices.below(4);
  for (std::size_t i = 0; i < times && !from.empty(); ++i) {
    const auto tokens = tokens_of(result);
    if (tokens.empty()) break;
    const Run given = some_run(choices, from);
    Run gone = some_run(choices, tokens);
    if (choices.once_in(3)) gone.end = gone.first;
    std::string next;
    for (std::size_t t = 0; t < gone.first; ++t) next += tokens[t];
    for (std::size_t t = given.first; t < given.end; ++t) next += from[t];
    for (std::size_t t = gone.end; t < tokens.size(); ++t) next += tokens[t];
    result = std::move(next);
  }
  return result;
}

std::string spoil_yaml(Choices& choices, std::string_view text, std::string_view donor) {
  const std::vector<std::string_view> old = lines_of(text);
  std::vector<std::string> lines(old.begin(), old.end());
  const std::vector<std::string_view> others = lines_of(donor);
  const std::size_t times = 1 + choices.below(5);
  for (std::size_t i = 0; i < times && !lines.empty(); ++i) {
    const std::size_t at = choices.below(lines.size());
    const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
    switch (choices.below(9)) {
      case 0:
        lines.erase(place);
        break;
      case 1:
        lines.insert(place, std::string(*place));
        break;
      case 2:
        std::swap(lines[at], lines[choices.below(lines.size())]);
        break;
      case 3:
        lines[at].insert(0, choices.below(5), ' ');
        break;
      case 4:
        lines[at].erase(0, std::min(lines[at].find_first_not_of(' '), choices.below(5)));
        break;
      case 5:
        if (!others.empty()) lines.emplace(place, others[choices.below(others.size())]);
        break;
      default:
        lines[at] = with_value(choices, lines[at], odd_scalar(choices));
        break;
    }
  }
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return choices.once_in(4) ? test::mutate(choices, result, donor) : result;
}

std::string spoil_json(Choices& choices, const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return test::mutate(choices, text, text);
  spoil(choices, json, 4 + choices.below(20));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string_view odd_scalar(Choices& choices) {
  return choices.one_of({"0",
                         "-1",
                         "1",
                         "2",
                         "3",
                         "0.5",
                         "-0.0",
                         "1e308",
                         "1e-320",
                         "1e999",
                         ".nan",
                         "-.inf",
                         "2147483648",
                         "4294967296",
                         "9223372036854775808",
                         "18446744073709551616",
                         "0x10",
                         "010",
                         "1_000",
                         "\"\"",
                         "\"\\0\"",
                         "[]",
                         "{}",
                         "~",
                         "null",
                         "true",
                         "no",
                         "&a [*a]",
                         "&a 1",
                         "*a",
                         "<<: {}",
                         "!!binary x",
                         "!t 1",
                         "? x",
                         "|",
                         ">",
                         "'",
                         "\"",
                         "{a: 1}",
                         "[1, 2]",
                         "[[[[1]]]]",
                         "1..3",
                         "3..1",
                         "1..4294967295",
                         "all",
                         "none",
                         "forward",
                         "back",
                         "external",
                         "idm",
                         "latency=0.3",
                         "../x",
                         "/dev/null",
                         "a b",
                         "x=y",
                         "\xC3\xA9",
                         "\xFF",
                         "\t",
                         "# x",
                         "%",
                         "@",
                         "`",
                         "1/0",
                         "inf"});
}

}  // namespace jaywalk::fuzz
