// `jaywalk replay`: a stored test, played again.

#include <fmt/format.h>

#include "experiment/export/write_file.h"
#include "experiment/report/replay_page.h"
#include "experiment/results/reader.h"
#include "tools/jaywalk/command.h"
#include "tools/jaywalk/stored_test.h"
#include "tools/jaywalk/viewer.h"
#include "tools/picture/gif.h"
#include "tools/picture/test_picture.h"

namespace jaywalk::command::replay {
namespace {

struct Wanted {
  std::optional<std::uint64_t> tick;
  double speed = 2;
};

std::optional<Wanted> read_wanted(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  Wanted wanted{.tick = arguments.number("tick", 0, diagnostics),
                .speed = arguments.positive("speed", diagnostics).value_or(2)};
  if (wanted.tick && !arguments.has("png")) {
    diagnostics.error("--tick", "has no meaning without --png");
  }
  if (!diagnostics.has_errors()) return wanted;
  console.report(diagnostics);
  return std::nullopt;
}

ExitCode play(const ResultsReader& store, const StoredTest& test, double speed, Console& console) {
  const InterruptGuard interrupt;
  Viewer viewer(name_of(store, test), speed, interrupt, console);
  TrialOptions options;
  options.print = [&](std::string_view line) { viewer.add_line(line); };
  options.observe = [&](const Crossing& crossing, const Mas& mas) {
    if (!interrupt.interrupted()) viewer.show(crossing, mas);
  };
  const auto result = store.rerun(test.id, options);
  if (result.ok()) return ExitCode::success;
  console.report(result.diagnostics());
  return ExitCode::failed;
}

ExitCode write_page(const ResultsReader& store, const StoredTest& test, const std::string& path,
                    Console& console) {
  const auto page = replay_page(store, test);
  if (!page.ok()) {
    console.report(page.diagnostics());
    return ExitCode::failed;
  }
  if (const auto why = write_file(path, page.value())) {
    console.error(fmt::format("cannot write '{}': {}", path, *why));
    return ExitCode::failed;
  }
  return ExitCode::success;
}

bool write(const std::string& path, std::string_view bytes, Console& console) {
  const auto why = bytes.empty() ? std::optional<std::string>("there is no memory for the picture")
                                 : write_file(path, bytes);
  if (why) console.error(fmt::format("cannot write '{}': {}", path, *why));
  return !why;
}

/// The tick that is wanted, or else that of the first event, or the last.
std::optional<std::size_t> tick_of(const Recording& recording, const Wanted& wanted,
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

ExitCode write_pictures(const ResultsReader& store, const StoredTest& test, const Wanted& wanted,
                        const Arguments& arguments, Console& console) {
  const auto prepared = store.prepared();
  const auto recording = store.recording(test.id);
  for (const Diagnostics* wrong : {prepared.ok() ? nullptr : &prepared.diagnostics(),
                                   recording.ok() ? nullptr : &recording.diagnostics()}) {
    if (wrong == nullptr) continue;
    console.report(*wrong);
    return ExitCode::failed;
  }
  const auto tick = tick_of(recording.value(), wanted, console);
  if (!tick) return ExitCode::usage;
  const picture::TestPicture picture(name_of(store, test), prepared.value()->scenario().world,
                                     recording.value());
  bool written = true;
  if (const auto path = arguments.text("png")) {
    written = write(*path, picture.draw(*tick).png(), console);
  }
  if (const auto path = arguments.text("gif")) {
    written = write(*path, movie(picture, recording.value(), wanted.speed), console) && written;
  }
  return written ? ExitCode::success : ExitCode::failed;
}

}  // namespace

CommandHelp help() {
  return {.usage = "STORE [OPTIONS]",
          .description =
              "Plays a test of a store: in the terminal, tick by tick, or as a page with a player\n"
              "that shows every agent's beliefs and intentions. The test is run again from what\n"
              "the store has of it, so that everything can be seen, whatever was stored.\n",
          .options =
              {
                  kStoredTestOptions[0],
                  kStoredTestOptions[1],
                  kStoredTestOptions[2],
                  {"speed", "N", "ticks per second in the terminal and in a GIF (default 2)"},
                  {"html", "FILE", "write the player's page instead"},
                  {"png", "FILE", "write a picture instead"},
                  {"tick", "T", "of this tick (default: when the first thing happens)"},
                  {"gif", "FILE", "write a moving picture instead"},
              },
          .examples =
              "  jaywalk replay runs.gpkg --test 7\n"
              "  jaywalk replay runs.gpkg --behaviour election --agents 5 --html replay.html\n"
              "  jaywalk replay runs.gpkg --test 7 --png moment.png --gif test.gif\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto wanted = read_wanted(arguments, console);
  if (!wanted) return ExitCode::usage;
  const auto store = open_results(arguments, "replay", console);
  if (!store) return ExitCode::usage;
  const auto test = find_stored_test(*store, arguments, console);
  if (!test) return ExitCode::usage;
  ExitCode code = ExitCode::success;
  if (const auto page = arguments.text("html")) code = write_page(*store, *test, *page, console);
  if (arguments.has("png") || arguments.has("gif")) {
    const ExitCode drawn = write_pictures(*store, *test, *wanted, arguments, console);
    return code == ExitCode::success ? drawn : code;
  }
  if (arguments.has("html")) return code;
  return play(*store, *test, wanted->speed, console);
}

}  // namespace jaywalk::command::replay
