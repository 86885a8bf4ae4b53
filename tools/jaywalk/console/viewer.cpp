// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/viewer.h"

#include <algorithm>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "tools/jaywalk/console/watch.h"

namespace jaywalk {
namespace {

/// Uses the size of the terminal, less the line of the cursor.
void fit_to_terminal(FrameOptions& options) {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return;
  if (size.ws_col > 0) options.columns = size.ws_col;
  if (size.ws_row > 1) options.rows = size.ws_row - 1;
}

}  // namespace

void Viewer::show(const World& world, const Mas& mas) {
  const bool live = console_.output_is_terminal();
  FrameOptions options{.title = title_, .colour = console_.output_colour()};
  if (live) fit_to_terminal(options);
  const std::string frame = draw_frame(world, mas, printed_, options);
  printed_.clear();
  if (live && lines_ > 0) {
    pause();
    console_.control(fmt::format("\x1b[{}F\x1b[J", lines_));
  }
  console_.print(frame);
  if (live) {
    console_.flush();
  } else {
    console_.print("\n");
  }
  lines_ = std::ranges::count(frame, '\n');
}

void Viewer::pause() const {
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(pause_);
  while (steady_clock::now() < end && !interrupt_.interrupted()) {
    std::this_thread::sleep_for(
        std::min<steady_clock::duration>(std::chrono::milliseconds(20), end - steady_clock::now()));
  }
}

}  // namespace jaywalk
