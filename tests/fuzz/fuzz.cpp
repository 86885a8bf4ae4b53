// SPDX-License-Identifier: Apache-2.0
// Inputs at random, through the interpreter and the commands, under limits. See README.md.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "tests/fuzz/campaign.h"
#include "tests/fuzz/run_case.h"

namespace jaywalk::fuzz {

std::span<const Target> targets() {
  static constexpr Target kTargets[] = {
#define JAYWALK_FUZZ_TARGET(name, summary) {#name, summary, target::name::make},
#include "tests/fuzz/targets.def"
#undef JAYWALK_FUZZ_TARGET
  };
  return kTargets;
}

namespace {

struct Options {
  CampaignOptions campaign;
  /// Empty: all of them.
  std::string target;
  /// The folder that the case is written to instead of being run.
  std::string show;
  bool list = false;
};

/// The value of a numeric option; nothing if it is none.
std::optional<double> number_of(const char* word) {
  char* end = nullptr;
  const double value = std::strtod(word, &end);
  return *end == '\0' && end != word && value >= 0 ? std::optional(value) : std::nullopt;
}

bool read_value(std::string_view name, const char* word, Options& options) {
  if (name == "--target") {
    options.target = word;
    return true;
  }
  if (name == "--findings") {
    options.campaign.findings = std::filesystem::absolute(word);
    return true;
  }
  if (name == "--show") {
    options.show = std::filesystem::absolute(word);
    return true;
  }
  const auto number = number_of(word);
  if (!number) return false;
  if (name == "--seconds") {
    options.campaign.seconds = *number;
  } else if (name == "--seed") {
    options.campaign.first = static_cast<std::uint64_t>(*number) << 32U;
  } else if (name == "--case") {
    options.campaign.first = std::strtoull(word, nullptr, 10);
    options.campaign.cases = 1;
  } else {
    return false;
  }
  return true;
}

bool read_options(std::span<char*> words, Options& options) {
  options.campaign.findings = std::filesystem::absolute(options.campaign.findings);
  options.campaign.first = std::uint64_t{1} << 32U;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (std::string_view(words[i]) == "--list") {
      options.list = true;
    } else if (i + 1 == words.size() || !read_value(words[i], words[i + 1], options)) {
      return false;
    } else {
      ++i;
    }
  }
  return true;
}

int run(const Options& options) {
  int findings = 0;
  bool known = false;
  CampaignOptions campaign = options.campaign;
  if (options.target.empty()) campaign.seconds /= static_cast<double>(targets().size());
  for (const Target& target : targets()) {
    if (!options.target.empty() && options.target != target.name) continue;
    known = true;
    if (options.list) {
      std::printf("%-14s %s\n", target.name.data(), target.summary.data());
    } else if (!options.show.empty()) {
      write_case(make_case(target, campaign.first), options.show);
    } else {
      findings += run_campaign(target, campaign);
    }
  }
  if (!known) std::fprintf(stderr, "fuzz: no target '%s'; see --list\n", options.target.c_str());
  if (!known) return 2;
  return findings == 0 ? 0 : 1;
}

}  // namespace
}  // namespace jaywalk::fuzz

int main(int count, char** words) {
  using namespace jaywalk::fuzz;
  Options options;
  if (!read_options({words, static_cast<std::size_t>(count)}, options)) {
    std::fprintf(stderr,
                 "usage: jaywalk_fuzz [--target NAME] [--seconds N] [--seed N] [--findings DIR]\n"
                 "       jaywalk_fuzz --target NAME --case N [--show DIR]\n"
                 "       jaywalk_fuzz --list\n");
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  return run(options);
}
