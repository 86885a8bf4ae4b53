#include "env/process/child_wait.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace jaywalk {

std::string wait_for_child(std::span<pollfd> descriptors,
                           std::chrono::steady_clock::time_point deadline) {
  using std::chrono::milliseconds;
  // A signal interrupts poll() in one thread only; the others have to look.
  constexpr std::int64_t kBetweenLooksMs = 50;
  while (!end_requested) {
    const auto left =
        std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    const auto patience = static_cast<int>(std::clamp<std::int64_t>(left, 0, kBetweenLooksMs));
    const int count = poll(descriptors.data(), descriptors.size(), patience);
    if (count > 0) return {};
    if (count < 0 && errno != EINTR) return std::strerror(errno);
    if (count == 0 && left <= kBetweenLooksMs) return std::string(kLate);
  }
  return std::string(kInterrupted);
}

}  // namespace jaywalk
