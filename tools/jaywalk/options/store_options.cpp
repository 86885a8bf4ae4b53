// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/store_options.h"

#include <limits>

#include <fmt/format.h>

#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

std::optional<StoreOptions> read_store_options(const Arguments& arguments,
                                               Diagnostics& diagnostics) {
  StoreOptions options;
  options.resume = arguments.has(option::kResume);
  options.retry_errors = arguments.has(option::kRetryErrors);
  if (options.retry_errors && !options.resume && arguments.has(option::kStore)) {
    diagnostics.error(option::kRetryErrors.dashed(), "has no meaning without --resume");
  }
  if (const auto text = arguments.text(option::kStoreLevel)) {
    options.level = parse_store_level(*text);
    if (!options.level) {
      diagnostics.error(option::kStoreLevel.dashed(),
                        fmt::format("expected summary, found or all, found '{}'", *text));
    }
  }
  if (const auto text = arguments.text(option::kShard)) {
    const auto shard = parse_shard(*text);
    options.shard = shard.value_or(Shard{});
    if (!shard) {
      diagnostics.error(option::kShard.dashed(),
                        fmt::format("expected I/N with I from 1 to N and N up to {}, found '{}'",
                                    std::numeric_limits<decltype(Shard::count)>::max(), *text),
                        "the second of four parts is 2/4");
    }
  }
  const auto path = arguments.text(option::kStore);
  if (path) {
    options.path = *path;
    return options;
  }
  for (const OptionName option :
       {option::kStoreLevel, option::kShard, option::kResume, option::kRetryErrors}) {
    if (arguments.has(option)) {
      diagnostics.error(option.dashed(), "has no meaning without --store");
    }
  }
  return std::nullopt;
}

bool is_kept(const std::optional<std::string>& failure, const std::string& path, Console& console) {
  if (failure) {
    console.report(unwritten_store(path, *failure));
  } else if (!path.empty()) {
    console.wrote(path);
  }
  return !failure;
}

}  // namespace jaywalk
