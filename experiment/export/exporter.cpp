// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/exporter.h"

#include <algorithm>
#include <array>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "experiment/scenario/files/write_file.h"

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

std::span<const Exporter> exporters() {
#define JAYWALK_EXPORTER(name, function, summary) Exporter{name, summary, function},
  static constexpr std::array kExporters{
#include "experiment/export/exporters.def"
  };
#undef JAYWALK_EXPORTER
  return kExporters;
}

const Exporter* find_exporter(std::string_view name) {
  const std::span<const Exporter> all = exporters();
  const auto found = std::ranges::find(all, name, &Exporter::name);
  return found == all.end() ? nullptr : &*found;
}

std::string file_stem(const ResultsReader& store, const TestKey& test) {
  return fmt::format("{}-{}-test-{}", store.description().behaviours[test.behaviour].name,
                     test.agents, test.number);
}

bool write_export(const ExportRequest& request, const std::string& name, std::string_view text,
                  std::vector<std::string>& written, Diagnostics& diagnostics) {
  return write_export(
      request, name,
      [text](const TextSink& sink) {
        sink(text);
        return true;
      },
      written, diagnostics);
}

bool write_export(const ExportRequest& request, const std::string& name, const TextSource& source,
                  std::vector<std::string>& written, Diagnostics& diagnostics) {
  std::string path = output_path(request.folder, name);
  if (const auto why = write_file(path, source, Links::replaced)) {
    if (why->empty()) return false;
    diagnostics.error(path, fmt::format("cannot be written: {}", *why));
    return false;
  }
  written.push_back(std::move(path));
  return true;
}

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
