#pragma once

// How models of the AV rank, as text for the terminal.

#include <string>

#include "experiment/compare/avs/av_ranking.h"

namespace jaywalk {

/// The ranking, then each behaviour with each model; empty if no models were compared.
[[nodiscard]] std::string render_avs(const AvRanking& ranking);

}  // namespace jaywalk
