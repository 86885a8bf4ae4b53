#pragma once

// The file in which `jaywalk repl` keeps its inputs from one session to the next.

#include <filesystem>
#include <optional>

namespace jaywalk {

/// `$XDG_STATE_HOME/jaywalk/repl_history`, by default below `~/.local/state`; its folder is made.
/// Nothing if there is no place to keep it.
[[nodiscard]] std::optional<std::filesystem::path> repl_history_file();

}  // namespace jaywalk
