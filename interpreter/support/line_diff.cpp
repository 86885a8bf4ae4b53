#include "interpreter/support/line_diff.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

namespace jaywalk {
namespace {

constexpr std::size_t kAround = 3;
/// Texts that differ in more lines than this are compared as a whole: the table would be too large.
constexpr std::size_t kMostCells = 16'000'000;

using Lines = std::vector<std::string_view>;

/// With their line breaks, so that a missing last one is a difference.
Lines with_breaks(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

struct Edit {
  char sign = ' ';
  std::string_view line;
};

/// The changed middles of both texts, by their longest common subsequence.
void append_middle(const Lines& a, const Lines& b, std::vector<Edit>& edits) {
  const std::size_t width = b.size() + 1;
  const bool is_large = (a.size() + 1) * width > kMostCells;
  std::vector<std::uint32_t> common(is_large ? 0 : (a.size() + 1) * width);
  for (std::size_t i = a.size(); !is_large && i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      common[i * width + j] =
          a[i] == b[j] ? common[(i + 1) * width + j + 1] + 1
                       : std::max(common[(i + 1) * width + j], common[i * width + j + 1]);
    }
  }
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    if (!is_large && i < a.size() && j < b.size() && a[i] == b[j]) {
      edits.push_back({' ', a[i]});
      ++i, ++j;
    } else if (i < a.size() && (j == b.size() || is_large ||
                                common[(i + 1) * width + j] >= common[i * width + j + 1])) {
      edits.push_back({'-', a[i++]});
    } else {
      edits.push_back({'+', b[j++]});
    }
  }
}

std::vector<Edit> edits_between(Lines a, Lines b) {
  std::vector<Edit> edits;
  const auto [from, to] = std::ranges::mismatch(a, b);
  const auto same = static_cast<std::size_t>(from - a.begin());
  for (std::size_t i = 0; i < same; ++i) edits.push_back({' ', a[i]});
  a.erase(a.begin(), from);
  b.erase(b.begin(), to);
  std::vector<Edit> end;
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    end.push_back({' ', a.back()});
    a.pop_back();
    b.pop_back();
  }
  append_middle(a, b, edits);
  edits.insert(edits.end(), end.rbegin(), end.rend());
  return edits;
}

/// Line numbers as diff writes them: of an empty range, the line before it.
std::string range(std::size_t first, std::size_t count) {
  return fmt::format("{},{}", count == 0 ? first : first + 1, count);
}

}  // namespace

std::string line_diff(std::string_view before, std::string_view after, std::string_view before_name,
                      std::string_view after_name) {
  if (before == after) return {};
  const std::vector<Edit> edits = edits_between(with_breaks(before), with_breaks(after));
  std::string text = fmt::format("--- {}\n+++ {}\n", before_name, after_name);
  std::size_t line_a = 0;
  std::size_t line_b = 0;
  std::size_t done = 0;
  const auto is_change = [](const Edit& edit) { return edit.sign != ' '; };
  while (true) {
    const auto change =
        std::find_if(edits.begin() + static_cast<std::ptrdiff_t>(done), edits.end(), is_change);
    if (change == edits.end()) return text;
    const auto at = static_cast<std::size_t>(change - edits.begin());
    const std::size_t begin = std::max(done, at - std::min(at, kAround));
    line_a += begin - done;
    line_b += begin - done;
    // The hunk ends where twice as many lines are the same as stand around a change.
    std::size_t last = at;
    for (std::size_t i = at; i < edits.size() && i <= last + 2 * kAround; ++i) {
      if (is_change(edits[i])) last = i;
    }
    const std::size_t end = std::min(edits.size(), last + 1 + kAround);
    std::size_t count_a = 0;
    std::size_t count_b = 0;
    std::string hunk;
    for (std::size_t i = begin; i < end; ++i) {
      count_a += edits[i].sign != '+' ? 1 : 0;
      count_b += edits[i].sign != '-' ? 1 : 0;
      hunk += fmt::format("{}{}", edits[i].sign, edits[i].line);
      if (!edits[i].line.ends_with('\n')) hunk += "\n\\ No newline at end of file\n";
    }
    text += fmt::format("@@ -{} +{} @@\n{}", range(line_a, count_a), range(line_b, count_b), hunk);
    line_a += count_a;
    line_b += count_b;
    done = end;
  }
}

}  // namespace jaywalk
