// SPDX-License-Identifier: Apache-2.0
// Loaded before a program starts (LD_PRELOAD), it stops every clock, so that two runs write the
// same times. Used by tests/compare_outputs; the program's children have their clocks again.

#include <cstdlib>
#include <ctime>
#include <sys/time.h>

namespace {

constexpr time_t kNow = 1'000'000'000;

[[gnu::constructor]] void keep_from_children() { unsetenv("LD_PRELOAD"); }

}  // namespace

extern "C" int clock_gettime(clockid_t /*clock*/, timespec* now) noexcept {
  *now = {.tv_sec = kNow, .tv_nsec = 0};
  return 0;
}

// SQLite asks this one.
extern "C" int gettimeofday(timeval* now, void* /*zone*/) noexcept {
  *now = {.tv_sec = kNow, .tv_usec = 0};
  return 0;
}
