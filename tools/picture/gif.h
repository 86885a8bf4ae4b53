// SPDX-License-Identifier: Apache-2.0
#pragma once

// Moving pictures as GIF (CompuServe 1990, GIF89a), through giflib.

#include <functional>
#include <string>

#include "tools/picture/canvas.h"

namespace jaywalk::picture {

struct Movie {
  int frames = 0;
  /// The picture of a frame; all are of the size of the first.
  std::function<Image(int frame)> frame;
  /// For how long each is shown, and the last one.
  double frame_s = 0.5;
  double last_s = 2;
};

/// The file's bytes, played again and again; empty if they could not be made. All frames share one
/// palette of 256 colours. REQUIRES: at least one frame, which is not empty.
[[nodiscard]] std::string to_gif(const Movie& movie);

}  // namespace jaywalk::picture
