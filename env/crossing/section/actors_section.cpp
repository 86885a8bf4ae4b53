// SPDX-License-Identifier: Apache-2.0
// Actors other than the pedestrians under comparison.

#include <fmt/format.h>

#include "env/config/parameter_settings.h"
#include "env/config/reader.h"
#include "env/crossing/crossing.h"
#include "env/crossing/section/crossing_section.h"

namespace jaywalk {
namespace {

class ActorsReader : CrossingPart {
 public:
  ActorsReader(const SectionContext& context, CrossingDraft& draft)
      : CrossingPart(context, draft) {}

  // Puts the actors into the world's parameters and their programs into draft_.agents, in the same
  // order.
  void read_actors(const ConfigNode& node, const std::string& path) {
    std::vector<WorldAgent>& programs = draft_.agents;
    programs.clear();
    draft_.actor_mps.clear();
    read_list<ActorParameters>(
        node, path, "a list of actors, {kind: cyclist, program: cyclist.asl, start: [2, 60]}",
        world().actors, [&](const ConfigNode& item, ActorParameters& actor) {
          WorldAgent& program = programs.emplace_back();
          program.origin = item.origin;
          std::optional<double>& mps = draft_.actor_mps.emplace_back();
          read_actor(item, path, actor, program, mps);
          if (actor.name.empty()) {
            actor.name = fmt::format("{}_{}", name(actor.kind), programs.size());
          }
          program.name = actor.name;
        });
  }

 private:
  void read_actor(const ConfigNode& item, const std::string& path, ActorParameters& actor,
                  WorldAgent& program, std::optional<double>& mps) {
    require(item, {"kind", "program"});
    const bool is_signal = item.find("crosswalk") != nullptr;
    if (!is_signal) require(item, {"start"});
    int crosswalk = 1;
    read_keys(item, path,
              {{"kind", choice<ActorKind>(actor.kind, {{"pedestrian", ActorKind::pedestrian},
                                                       {"cyclist", ActorKind::cyclist},
                                                       {"vehicle", ActorKind::vehicle},
                                                       {"signal", ActorKind::signal}})},
               {"name",
                [&](const ConfigNode& value, const std::string&) {
                  const auto name = reader_.text(value, "a name");
                  if (name && is_atom(*name)) {
                    actor.name = *name;
                  } else if (name) {
                    reader_.unexpected(value, "a name in small letters, as an atom has it");
                  }
                }},
               {"program",
                [&](const ConfigNode& value, const std::string&) {
                  if (const auto file = reader_.text(value, "the path of a program")) {
                    program.program =
                        program_path(context_.folder, *file, kCrossing, context_.files);
                  }
                }},
               {"start",
                [&](const ConfigNode& value, const std::string&) {
                  if (const auto at = reader_.number_pair(value, {0, 1e5}, PairOrder::any)) {
                    actor.start = cell({(*at)[0], (*at)[1]});
                  }
                }},
               {"way", choice<Direction>(actor.way, {{"forward", Direction::forward},
                                                     {"back", Direction::back},
                                                     {"left", Direction::left},
                                                     {"right", Direction::right}})},
               {"speed", speed(actor.speed, kSpeed, "speed_mps")},
               {"speed_mps", speed(mps, kSpeed, "speed_mps")},
               {"crosswalk", integer(crosswalk, {1, static_cast<std::int64_t>(kMaxItems)})},
               {"parameters", [&](const ConfigNode& value, const std::string&) {
                  read_parameters(value, reader_, program.parameters);
                }}});
    actor.crosswalk = static_cast<std::size_t>(crosswalk - 1);
    if (is_signal) actor.kind = ActorKind::signal;
  }
};

}  // namespace

void read_actors(const ConfigNode& node, const std::string& path, const SectionContext& context,
                 CrossingDraft& draft) {
  ActorsReader(context, draft).read_actors(node, path);
}

}  // namespace jaywalk
