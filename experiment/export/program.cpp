#include "experiment/export/program.h"

#include <array>
#include <sys/wait.h>
#include <unistd.h>

namespace jaywalk {
namespace {

void read_all(int pipe, std::string& text) {
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(pipe, buffer.data(), buffer.size());
    if (count <= 0) return;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

int run_program(std::vector<std::string> words, std::string* output) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{-1, -1};
  if (output != nullptr && pipe(ends.data()) != 0) return 1;
  const pid_t child = fork();
  if (child == 0) {
    if (output != nullptr) {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
    }
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  if (output != nullptr) {
    close(ends[1]);
    if (child > 0) read_all(ends[0], *output);
    close(ends[0]);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace jaywalk
