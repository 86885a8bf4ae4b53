// SPDX-License-Identifier: Apache-2.0
// `jaywalk replay`: a stored test, played again.

#include "experiment/report/player/player.h"
#include "experiment/results/reader.h"
#include "experiment/test_run/test_run.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/commands/replay_pictures.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/watch.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/stored_test.h"

namespace jaywalk::command::replay {
namespace {

std::optional<ReplayWishes> read_wishes(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  ReplayWishes wanted{.tick = arguments.number(option::kTick, 0, diagnostics),
                      .speed = arguments.positive(option::kSpeed, diagnostics).value_or(2)};
  if (wanted.tick && !arguments.has(option::kPng)) {
    diagnostics.error(option::kTick.dashed(), "has no meaning without --png");
  }
  if (!diagnostics.has_errors()) return wanted;
  console.report(diagnostics);
  return std::nullopt;
}

ExitCode play(const ResultsReader& store, const StoredTest& test, double speed, Console& console) {
  const InterruptGuard interrupt;
  Viewer viewer(name_of(store, test), speed, interrupt, console);
  TestOptions options;
  options.print = [&](std::string_view line) { viewer.add_line(line); };
  options.observe = [&](const World& world, const Mas& mas) {
    if (!interrupt.interrupted()) viewer.show(world, mas);
  };
  const auto result = store.rerun(test.id, options);
  if (result.ok()) return ExitCode::success;
  console.report(result.diagnostics());
  return ExitCode::usage;
}

ExitCode write_page(const ResultsReader& store, const StoredTest& test, const std::string& path,
                    Console& console) {
  const auto page = replay_page(store, test);
  if (!page.ok()) {
    console.report(page.diagnostics());
    return ExitCode::usage;
  }
  return write_output(path, page.value(), console) ? ExitCode::success : ExitCode::failed;
}

}  // namespace

CommandHelp help() {
  return {
      .usage = "STORE [OPTIONS]",
      .description =
          "Plays a test of a store: in the terminal, tick by tick, or as a page with a player\n"
          "that shows every agent's beliefs and intentions. The test is run again from what\n"
          "the store has of it, so that everything can be seen, whatever was stored.\n",
      .options =
          {
              kStoredTestOptions[0],
              kStoredTestOptions[1],
              kStoredTestOptions[2],
              kStoredTestOptions[3],
              kAllowCommandsOption,
              {option::kSpeed, "N", "ticks per second in the terminal and in a GIF (default 2)"},
              {option::kHtml, "FILE", "write the player's page instead", Written::file},
              {option::kPng, "FILE", "write a picture instead", Written::file},
              {option::kTick, "T", "of this tick (default: when the first thing happens)"},
              {option::kGif, "FILE", "write a moving picture instead", Written::file},
          },
      .examples =
          "  jaywalk replay runs.gpkg --test 7\n"
          "  jaywalk replay runs.gpkg --behaviour election --agents 5 --html replay.html\n"
          "  jaywalk replay runs.gpkg --test 7 --png moment.png --gif test.gif\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto wanted = read_wishes(arguments, console);
  if (!wanted) return ExitCode::usage;
  const auto store = open_results(arguments, "replay", console);
  if (!store) return ExitCode::usage;
  const auto test = find_stored_test(*store, arguments, console);
  if (!test) return ExitCode::usage;
  if (arguments.has(option::kPng) || arguments.has(option::kGif)) {
    const ExitCode drawn = write_pictures(*store, *test, *wanted, arguments, console);
    if (drawn != ExitCode::success || !arguments.has(option::kHtml)) return drawn;
  }
  if (const auto page = arguments.text(option::kHtml))
    return write_page(*store, *test, *page, console);
  return play(*store, *test, wanted->speed, console);
}

}  // namespace jaywalk::command::replay
