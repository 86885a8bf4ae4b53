// SPDX-License-Identifier: Apache-2.0
// `jaywalk lsp`: what editors ask about programs, on standard input and output.

#include <array>
#include <iostream>
#include <istream>
#include <poll.h>
#include <streambuf>
#include <unistd.h>

#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/lsp/lsp_protocol.h"
#include "tools/jaywalk/lsp/lsp_server.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::command::lsp {
namespace {

/// Standard input that can be asked whether something waits to be read.
class Input : public std::streambuf {
 public:
  [[nodiscard]] bool waits() const {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    return gptr() != egptr() || poll(&input, 1, 0) > 0;
  }

 private:
  int_type underflow() override {
    const ssize_t count = read(STDIN_FILENO, buffer_.data(), buffer_.size());
    if (count <= 0) return traits_type::eof();
    setg(buffer_.data(), buffer_.data(), buffer_.data() + count);
    return traits_type::to_int_type(*gptr());
  }

  std::array<char, 65536> buffer_{};
};

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "[OPTIONS]",
      .description =
          "A language server for programs (.asl) and projects (.mas2j), to be started by an\n"
          "editor: it speaks the Language Server Protocol on standard input and output.\n"
          "Diagnostics are those of `jaywalk check`, with their codes; there are hover,\n"
          "completion, definitions, references, renaming, an outline and formatting. The\n"
          "README says how editors attach it.\n",
      .options = {{option::kStdio, "", "accepted; there is no other way"}},
      .examples =
          "  jaywalk lsp\n"
          "  jaywalk lsp --include agents/common\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto include_path = read_include_path(arguments, console);
  if (!include_path) return ExitCode::usage;
  if (!arguments.operands().empty()) {
    console.error("expected no file", "editors send the texts themselves");
    return ExitCode::usage;
  }
  jaywalk::lsp::Server server(*include_path, [](std::string_view message) {
    jaywalk::lsp::write_frame(std::cout, message);
  });
  Input input;
  std::istream messages(&input);
  while (!server.has_exited()) {
    if (!input.waits()) server.settle();
    const auto frame = jaywalk::lsp::read_frame(messages);
    if (!frame || !std::cout) break;
    if (frame->is_broken) {
      server.receive_broken();
    } else {
      server.receive(frame->content);
    }
  }
  return server.was_shut_down() ? ExitCode::success : ExitCode::failed;
}

}  // namespace jaywalk::command::lsp
