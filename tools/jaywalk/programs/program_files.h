#pragma once

// The files that operands of a command mean, where folders stand for what lies in them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/jaywalk/console/console.h"

namespace jaywalk {

/// The operand for standard input.
inline constexpr std::string_view kStandardInput = "-";

/// Each operand as it is; a folder becomes its files with one of the endings, those of its folders
/// included, by name. What is hidden (`.git`) is left out. False: a folder has none or cannot be
/// read, which is reported.
bool expand_folders(std::span<const std::string> operands,
                    std::span<const std::string_view> endings, Console& console,
                    std::vector<std::string>& files);

}  // namespace jaywalk
