#include "tools/jaywalk/repl/repl_history.h"

#include <cstdlib>
#include <system_error>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// Ignores a relative path in XDG_STATE_HOME, as the standard demands.
std::optional<fs::path> state_folder() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state);
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return std::nullopt;
  return fs::path(home) / ".local" / "state";
}

}  // namespace

std::optional<fs::path> repl_history_file() {
  const auto folder = state_folder();
  if (!folder) return std::nullopt;
  std::error_code problem;
  fs::create_directories(*folder / "jaywalk", problem);
  if (problem) return std::nullopt;
  const fs::path file = *folder / "jaywalk" / "repl_history";
  // A pipe would be waited for, a device read without end.
  const fs::file_status status = fs::status(file, problem);
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;
  return file;
}

}  // namespace jaywalk
