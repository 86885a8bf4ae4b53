// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/input/read_pipe.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

namespace jaywalk {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{10};

class Pipe {
 public:
  // Without O_NONBLOCK, opening waits for a writer, for ever if need be.
  explicit Pipe(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Pipe() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

  /// Appends what there is; as `read`: 0 at the end, -1 and errno on failure.
  ssize_t append_to(std::string& text) {
    std::array<char, 4096> block;
    const ssize_t bytes = ::read(descriptor_, block.data(), block.size());
    if (bytes > 0) text.append(block.data(), static_cast<std::size_t>(bytes));
    return bytes;
  }

  /// Without a writer a pipe reads as one that has ended; with a writer that has written
  /// nothing yet, as EAGAIN.
  bool find_writer(std::string& text, std::chrono::milliseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
      const ssize_t bytes = append_to(text);
      if (bytes > 0 || (bytes < 0 && errno == EAGAIN)) return true;
      std::this_thread::sleep_for(kBetweenLooks);
    }
    return false;
  }

  void wait_from_now_on() { ::fcntl(descriptor_, F_SETFL, O_RDONLY); }

 private:
  int descriptor_;
};

Diagnostics trouble(const std::string& path, std::string message) {
  Diagnostics diagnostics;
  diagnostics.error(path, std::move(message));
  return diagnostics;
}

}  // namespace

Result<std::string> read_pipe(const std::string& path, std::size_t max_bytes,
                              std::chrono::milliseconds patience) {
  Pipe pipe(path);
  if (!pipe.is_open()) {
    return trouble(path, fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  std::string text;
  if (!pipe.find_writer(text, patience)) return trouble(path, "a pipe that nobody writes to");
  pipe.wait_from_now_on();
  ssize_t bytes = 1;
  while (bytes > 0 && text.size() <= max_bytes) bytes = pipe.append_to(text);
  if (bytes < 0) return trouble(path, "cannot be read to its end");
  return text;
}

}  // namespace jaywalk
