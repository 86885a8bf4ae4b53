#include "tools/jaywalk/command.h"
namespace jaywalk::command::check {
CommandHelp help() { return {}; }
ExitCode execute(const Arguments&, Console&) { return ExitCode::success; }
}  // namespace jaywalk::command::check
