#pragma once

// A test as a careful and competent driver would have driven it instead of the AV, for the signal
// `avoidable`. Read env/vehicle/careful_driver.h first.

#include <vector>

#include "env/vehicle/sight.h"
#include "experiment/judge/signals/signals.h"

namespace jaywalk {

/// The car's state at every tick of the record, and after its end until that driver stands or has a
/// free road ahead. All others move as recorded, whatever the driver does, and after the record
/// ends as they did last. As in the world (Ground::moves_evenly), they go evenly during a tick, or
/// a tick's moves are made when it begins, and then the driver drives for as long as the tick
/// lasts.
///
/// The driver begins as the AV does, with the ground's cruising speed. Where that is not known, it
/// drives as the AV did until the first risk, and cruises at the speed that it has then.
[[nodiscard]] std::vector<ActorState> careful_drive(const TestView& view);

/// The strip in which a road user is a risk to the AV: its lane, or the width of its body if it
/// drives in no lane.
[[nodiscard]] Strip risk_strip(const TestView& view);

/// A road user's state at a tick, which may be after the record's end.
[[nodiscard]] ActorState state_beyond(const TestView& view, ActorIndex actor, std::size_t tick);

}  // namespace jaywalk
