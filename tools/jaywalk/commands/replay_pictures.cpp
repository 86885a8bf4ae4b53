// SPDX-License-Identifier: Apache-2.0
// Part of the program `jaywalk-draw` alone.

#include "tools/jaywalk/commands/replay_pictures.h"

#include <fmt/format.h>

#include "experiment/report/player/player.h"
#include "experiment/scenario/files/write_file.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/picture/gif.h"
#include "tools/picture/test_picture.h"

namespace jaywalk {
namespace {

bool write(const std::string& path, std::string_view bytes, Console& console) {
  const auto why = bytes.empty() ? std::optional<std::string>("there is no memory for the picture")
                                 : write_file(path, bytes);
  if (why) console.error(fmt::format("cannot write '{}': {}", path, *why));
  if (!why) console.wrote(path);
  return !why;
}

/// The tick that is wanted, or else that of the first event, or the last.
std::optional<std::size_t> tick_of(const Recording& recording, const ReplayWishes& wanted,
                                   Console& console) {
  const std::size_t last = recording.scenes() - 1;
  if (!wanted.tick) return recording.events().empty() ? last : recording.events()[0].tick;
  if (*wanted.tick <= last) return *wanted.tick;
  console.error(fmt::format("the test has no tick {}", *wanted.tick),
                fmt::format("its last is {}", last));
  return std::nullopt;
}

std::string movie(const picture::TestPicture& picture, const Recording& recording, double speed) {
  // A test of many short ticks is shown in fewer frames.
  constexpr std::size_t kMostFrames = 600;
  const std::size_t last = recording.scenes() - 1;
  const std::size_t step = last / kMostFrames + 1;
  const std::size_t frames = last / step + 1;
  return picture::to_gif(
      {.frames = static_cast<int>(frames),
       .frame =
           [&](int frame) { return picture.draw(static_cast<std::size_t>(frame) * step).image(); },
       .frame_s = static_cast<double>(step) / speed});
}

}  // namespace

ExitCode write_pictures(const ResultsReader& store, const StoredTest& test,
                        const ReplayWishes& wanted, const Arguments& arguments, Console& console) {
  const auto prepared = store.prepared();
  const auto recording = store.recording(test.id);
  const auto twin = twin_recording(store, test);
  for (const Diagnostics* wrong : {prepared.ok() ? nullptr : &prepared.diagnostics(),
                                   recording.ok() ? nullptr : &recording.diagnostics(),
                                   twin.ok() ? nullptr : &twin.diagnostics()}) {
    if (wrong == nullptr) continue;
    console.report(*wrong);
    return ExitCode::usage;
  }
  const auto tick = tick_of(recording.value(), wanted, console);
  if (!tick) return ExitCode::usage;
  const picture::TestPicture picture(name_of(store, test),
                                     prepared.value()->scenario().world->plan(), recording.value(),
                                     twin.value() ? &*twin.value() : nullptr);
  bool written = true;
  if (const auto path = arguments.text(option::kPng)) {
    written = write(*path, picture.draw(*tick).png(), console);
  }
  if (const auto path = arguments.text(option::kGif)) {
    written = write(*path, movie(picture, recording.value(), wanted.speed), console) && written;
  }
  return written ? ExitCode::success : ExitCode::failed;
}

}  // namespace jaywalk
