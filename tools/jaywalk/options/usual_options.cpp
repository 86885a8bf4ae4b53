#include "tools/jaywalk/options/usual_options.h"

#include <algorithm>
#include <thread>

#include "interpreter/support/text.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

std::vector<std::string> listed(const Arguments& arguments, OptionName option) {
  std::vector<std::string> items;
  for (const std::string& text : arguments.texts(option)) {
    std::string_view rest = text;
    while (true) {
      const std::size_t comma = rest.find(',');
      items.emplace_back(trimmed(rest.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  return items;
}

unsigned read_threads(const Arguments& arguments, Diagnostics& diagnostics) {
  constexpr std::uint64_t kMost = 1024;
  const auto cores = std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, kMost);
  return static_cast<unsigned>(
      arguments.number(option::kThreads, 1, diagnostics, kMost).value_or(cores));
}

}  // namespace jaywalk
