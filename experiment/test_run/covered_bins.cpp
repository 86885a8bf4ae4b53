// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/covered_bins.h"

#include <charconv>

#include <fmt/format.h>

namespace jaywalk {
namespace {

template <class Number>
bool read_number(std::string_view& text, Number& value) {
  if (!text.starts_with(' ')) return false;
  text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

}  // namespace

std::string feedback_text(const std::vector<CoveredBin>& feedback) {
  std::string text;
  for (const CoveredBin& each : feedback) {
    text += fmt::format("{}{} {} {}", text.empty() ? "" : "; ", each.item, each.bin, each.times);
  }
  return text;
}

std::optional<std::vector<CoveredBin>> parse_feedback(std::string_view text) {
  std::vector<CoveredBin> feedback;
  if (text.empty()) return feedback;
  while (true) {
    const std::size_t blank = text.find(' ');
    if (blank == 0 || blank == std::string_view::npos) return std::nullopt;
    CoveredBin bin{.item = std::string(text.substr(0, blank))};
    text.remove_prefix(blank);
    if (!read_number(text, bin.bin) || !read_number(text, bin.times)) return std::nullopt;
    if (bin.bin == 0) return std::nullopt;
    feedback.push_back(std::move(bin));
    if (text.empty()) return feedback;
    if (!text.starts_with("; ")) return std::nullopt;
    text.remove_prefix(2);
  }
}

std::vector<CoveredBin> feedback_of(const SituationCoverage& coverage) {
  std::vector<CoveredBin> feedback;
  const auto items = situation_items();
  for (std::size_t item = 0; item < items.size(); ++item) {
    const std::vector<std::uint64_t>& times = coverage.counts()[item];
    for (std::uint32_t bin = 0; bin < times.size(); ++bin) {
      if (times[bin] > 0) feedback.push_back({std::string(items[item].name), bin + 1, times[bin]});
    }
  }
  return feedback;
}

}  // namespace jaywalk
