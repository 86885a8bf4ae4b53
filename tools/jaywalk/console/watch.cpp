// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/watch.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/support/text.h"
#include "tools/jaywalk/console/frame_cells.h"

namespace jaywalk {
namespace {

constexpr int kLabelWidth = 13;

/// The text cut to `columns` letters, without codes that move the terminal's cursor.
std::string fitted(std::string_view text, int columns) {
  std::string line;
  int letters = 0;
  for (const char c : text) {
    if (begins_character(c) && ++letters > columns) break;
    line += static_cast<unsigned char>(c) < ' ' || c == 0x7F ? ' ' : c;
  }
  return line;
}

std::string band_label(const Band& band) {
  if (band.kind == BandKind::pavement) return "pavement";
  return band.direction == Direction::forward ? "lane ->" : "lane <-";
}

/// `fitting` of `size` places, among them the one at `focus`, with `before` places in front of it.
Interval window(int size, int fitting, int focus, int before) {
  const int most = std::min(size, fitting);
  const int first = std::clamp(focus - before, 0, size - most);
  return {.first = first, .last = first + most - 1};
}

/// The entries in lines of whole entries.
std::vector<std::string> legend_lines(const Crossing& crossing, int columns) {
  std::vector<std::string> lines;
  for (const std::string& entry : legend(crossing)) {
    const std::size_t room = static_cast<std::size_t>(columns);
    if (lines.empty() || lines.back().size() + 3 + entry.size() > room) {
      lines.push_back(entry);
    } else {
      lines.back() += "   " + entry;
    }
  }
  return lines;
}

std::string road_line(const FrameCells& picture, int row, Interval cells, Colour colour) {
  std::string line;
  std::string_view style;
  for (int y = cells.first; y <= cells.last; ++y) {
    const Glyph each = picture.at({.x = row, .y = y});
    if (colour == Colour::on && each.style != style) line += style = each.style;
    line += each.letter;
  }
  if (colour == Colour::on) line += kPlainStyle;
  return line;
}

/// A line with the number of every tenth cell.
std::string scale_line(Interval cells) {
  std::string scale(kLabelWidth, ' ');
  for (int y = cells.first; y <= cells.last; ++y) {
    const auto column = static_cast<std::size_t>(kLabelWidth + y - cells.first);
    const std::string number = std::to_string(y);
    if (y % 10 != 0 || y > cells.last + 1 - static_cast<int>(number.size())) continue;
    scale += std::string(column - std::min(column, scale.size()), ' ') + number;
  }
  return scale;
}

/// The road seen from above, at most `most` of its rows, and the scale below.
std::vector<std::string> road(const Crossing& crossing, const FrameOptions& options, int most) {
  const CrossingParameters& parameters = crossing.parameters();
  const Grid& grid = crossing.layout().grid();
  const int width = std::max(options.columns - kLabelWidth, 10);
  // A quarter of the picture is behind the AV: what happens is ahead of it.
  const Interval cells = window(grid.cells, width, av_situation(crossing).edge, width / 4);
  const Interval rows = window(grid.rows, most, parameters.av.rows.first, most / 2);
  const FrameCells picture(crossing);
  const std::vector<Interval> bands = band_rows(parameters);
  std::vector<std::string> lines;
  for (std::size_t band = 0; band < bands.size(); ++band) {
    for (int x = bands[band].first; x <= bands[band].last; ++x) {
      if (!rows.contains(x)) continue;
      const bool first = x == bands[band].first || x == rows.first;
      const std::string label = first ? band_label(parameters.bands[band]) : "";
      std::string line =
          fmt::format("{:>2} {:<9} ", x, label) + road_line(picture, x, cells, options.colour);
      line.erase(line.find_last_not_of(' ') + 1);
      lines.push_back(std::move(line));
    }
  }
  lines.push_back(scale_line(cells));
  return lines;
}

/// Its intentions as they are described, less the annotation that every goal of its own has.
std::string intentions_of(const Mas& mas, AgentId id) {
  constexpr std::string_view kOwn = "[source(self)]";
  std::string text = fmt::format("{}", fmt::join(mas.describe_intentions(id), "; "));
  for (auto at = text.find(kOwn); at != std::string::npos; at = text.find(kOwn, at)) {
    text.erase(at, kOwn.size());
  }
  return text.empty() ? "no intention" : text;
}

/// The line of a vehicle of a simulator's own traffic, which has no agent.
std::string traffic_line(const Crossing& crossing, std::size_t body) {
  const RoadUser& user = crossing.bodies()[body];
  const char letter = letter_of(crossing, body);
  const std::string name = crossing.actors()[body + 1].name;
  if (user.absent) return fmt::format("{} {} is not on the road", letter, name);
  const Position at = cell(user.place);
  return fmt::format("{} at {:>2},{:<3} {}, {:.1f} m/s", letter, at.x, at.y, name,
                     user.step * crossing.parameters().cell_m / crossing.parameters().tick_s);
}

std::string body_line(const Crossing& crossing, const Mas& mas, std::size_t body) {
  const char letter = letter_of(crossing, body);
  const std::size_t pedestrians = crossing.positions().size();
  if (body >= pedestrians + crossing.parameters().actors.size()) {
    return traffic_line(crossing, body);
  }
  const std::string intentions = intentions_of(mas, static_cast<AgentId>(body));
  if (body < pedestrians) {
    const Position at = crossing.positions()[body];
    const AgentOutcome& outcome = crossing.result().agents[body];
    return fmt::format("{} at {:>2},{:<3} score {:>4}  {}", letter, at.x, at.y,
                       outcome.reward - outcome.cost, intentions);
  }
  const ActorParameters& actor = crossing.parameters().actors[body - pedestrians];
  if (actor.kind == ActorKind::signal) {
    return fmt::format("{} {} is {}  {}", letter, actor.name,
                       name(crossing.signal(actor.crosswalk)), intentions);
  }
  const RoadUser& user = crossing.bodies()[body];
  if (user.gone) return fmt::format("{} {} has left the road", letter, actor.name);
  const Position at = cell(user.place);
  return fmt::format("{} at {:>2},{:<3} {}  {}", letter, at.x, at.y, actor.name, intentions);
}

/// The first of all bodies that fit.
std::vector<std::string> body_lines(const Crossing& crossing, const Mas& mas, std::size_t most) {
  const std::size_t all = crossing.bodies().size();
  const std::size_t shown = all <= most ? all : std::max<std::size_t>(most, 1) - 1;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(body_line(crossing, mas, i));
  if (shown < all) lines.push_back(fmt::format("and {} more agents", all - shown));
  return lines;
}

std::string tick_line(const Crossing& crossing) {
  const auto [edge, zone] = av_situation(crossing);
  std::string text = fmt::format("tick {}: AV at {}, {:.1f} m/s", crossing.ticks(), edge,
                                 crossing.vehicle().speed_mps());
  std::string_view before = ", collision with ";
  for (const Collision& each : crossing.result().collisions) {
    text += fmt::format("{}{}", before, letter_of(crossing, each.body));
    before = ", ";
  }
  if (crossing.result().success) {
    text += fmt::format(", precondition met in {} to {}", zone.first, zone.last);
  } else if (!crossing.finished() && !zone.empty()) {
    text += fmt::format(", zone of the next tick {} to {}", zone.first, zone.last);
  }
  return text;
}

/// The printed texts as lines without line breaks, at most the last `most`. REQUIRES: most > 0.
std::vector<std::string> last_lines(const std::vector<std::string>& printed, std::size_t most) {
  std::vector<std::string> lines;
  for (std::string_view text : printed) {
    for (bool more = true; more;) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      lines.push_back("  " + std::string(text.substr(0, end)));
      more = end < text.size();
      text.remove_prefix(more ? end + 1 : end);
    }
  }
  if (lines.size() > most) {
    const std::size_t hidden = lines.size() - most + 1;
    lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(hidden));
    lines.insert(lines.begin(), fmt::format("  ({} more lines)", hidden));
  }
  return lines;
}

/// Uses the size of the terminal, less the line of the cursor.
void fit_to_terminal(FrameOptions& options) {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return;
  if (size.ws_col > 0) options.columns = size.ws_col;
  if (size.ws_row > 1) options.rows = size.ws_row - 1;
}

}  // namespace

namespace {

/// A frame for a world without a picture of its own: the places of all actors in metres.
std::string draw_places(const World& world, const Mas& mas, const std::vector<std::string>& printed,
                        const FrameOptions& options) {
  const std::vector<Actor> actors = world.actors();
  const Scene scene = world.scene();
  const WorldResult& result = world.result();
  std::vector<std::string> lines{options.title};
  std::string tick = fmt::format("tick {}: AV at {:.1f} m, {:.1f} m/s", world.ticks(), scene[0].y_m,
                                 scene[0].speed_mps);
  for (const Collision& each : result.collisions) {
    tick += fmt::format(", collision with {}", actors[each.body + 1].name);
  }
  if (result.success) tick += ", precondition met";
  lines.push_back(std::move(tick));
  const std::size_t room = static_cast<std::size_t>(std::max(options.rows - 3, 2));
  for (std::size_t i = 1; i < actors.size() && i < room; ++i) {
    const auto id = static_cast<AgentId>(i - 1);
    const bool has_agent = i - 1 < mas.agent_count();
    lines.push_back(
        fmt::format("{:>4} {:>+7.1f} m ahead, {:>5.1f} m from the left, {:>5.1f} m/s  {}",
                    actors[i].name, scene[i].y_m - scene[0].y_m, scene[i].x_m, scene[i].speed_mps,
                    has_agent ? intentions_of(mas, id) : ""));
  }
  for (std::string& said : last_lines(printed, std::max(room / 2, std::size_t{1}))) {
    lines.push_back(std::move(said));
  }
  std::string text;
  for (const std::string& line : lines) {
    std::string shown = fitted(line, options.columns);
    shown.erase(shown.find_last_not_of(' ') + 1);
    text += shown + '\n';
  }
  return text;
}

}  // namespace

std::string draw_frame(const World& world, const Mas& mas, const std::vector<std::string>& printed,
                       const FrameOptions& options) {
  const Crossing* const known = find_crossing(world);
  if (known == nullptr) return draw_places(world, mas, printed, options);
  const Crossing& crossing = *known;
  constexpr int kLeastForAgents = 4;
  const std::vector<std::string> meanings = legend_lines(crossing, options.columns);
  const int bodies = static_cast<int>(crossing.bodies().size());
  // Title, tick, scale and legend always have their lines; the road comes before the agents.
  const int fixed = 3 + static_cast<int>(meanings.size());
  const int rows = options.rows - fixed - std::min(bodies, kLeastForAgents);
  std::vector<std::string> lines = road(crossing, options, std::max(rows, 1));
  const auto left = static_cast<std::size_t>(
      std::max(options.rows - fixed + 1 - static_cast<int>(lines.size()), 1));
  // Printed texts get the lines that the bodies leave free, and at least half of the lines.
  const std::size_t spare = left - std::min(left, crossing.bodies().size());
  const auto said = last_lines(printed, std::max({spare, left / 2, std::size_t{1}}));

  std::string text = fitted(options.title, options.columns) + '\n' +
                     fitted(tick_line(crossing), options.columns) + '\n';
  for (const std::string& line : lines) text += line + '\n';
  const auto add = [&](const std::vector<std::string>& more) {
    for (const std::string& line : more) text += fitted(line, options.columns) + '\n';
  };
  add(meanings);
  add(body_lines(crossing, mas, left - std::min(left, said.size())));
  add(said);
  return text;
}

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
