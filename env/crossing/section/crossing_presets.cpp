// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "env/crossing/section/crossing_section.h"

namespace jaywalk {
namespace {

// Values of the case study's sources where these disagree. Each text is what a scenario would say,
// on top of `paper`, whose values are the defaults of CrossingParameters.
constexpr std::array kCrossingPresets{
    Preset{"paper", "the case study as its authors' program has it: the defaults", "",
           PresetResults::published},
    Preset{"draft", "the draft's money: reward 20, pavement 1, road 7 on top of it",
           R"(world:
  scoring: {reward: 20, pavement_cost: 1, road_cost: 7, costs: add}
)"},
    Preset{"published",
           "zone and distances from the end of 8 cells of stopping distance, the AV 8 cells back",
           R"(world:
  av: {start: -8, stopping_distance: 8}
  zone: {from: stopping_distance}
)",
           PresetResults::published},
    Preset{"published-literal",
           "as published: the AV starts at 0, zone 9 to 14 ahead, dead zones 12, 6, 30 and 48",
           R"(world:
  av: {stopping_distance: 8}
  zone: {ahead: [9, 14]}
  spawn:
    dead_zones: {0: 12, 1: 6, 10: 30, 11: 48}
)"},
    Preset{"as-published-program",
           "paper with the quirks of the program that the published figures come from",
           R"(world:
  av: {carry_over: true}
behaviours:
  random_behaviour: {parameters: {first_way: back}}
  election: {parameters: {radius_limit: inclusive_alone}}
)",
           PresetResults::published},
};

}  // namespace

std::span<const Preset> crossing_presets() { return kCrossingPresets; }

}  // namespace jaywalk
