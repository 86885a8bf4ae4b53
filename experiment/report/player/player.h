// SPDX-License-Identifier: Apache-2.0
#pragma once

// A page that plays a test: it draws every tick and shows an agent's beliefs and intentions. The
// page loads no other file and needs no network.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "env/ground.h"
#include "experiment/judge/recording.h"
#include "experiment/results/reader.h"
#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/mas/mas.h"

namespace jaywalk {

/// Records the agents' beliefs and intentions at every tick, and the plans that they chose. Pass it
/// to a test as observer, and its `observe` as callback.
class MindRecorder : public ReasoningObserver {
 public:
  struct Mind {
    /// Indices into texts().
    std::vector<std::size_t> intentions;
    std::vector<std::size_t> beliefs;
    /// The plans chosen in the tick, each with the event that it was chosen for.
    std::vector<std::size_t> plans;
  };

  void observe(const Mas& mas);
  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override;

  /// For each tick, each agent's.
  [[nodiscard]] const std::vector<std::vector<Mind>>& minds() const { return minds_; }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::vector<std::size_t> intern(const std::vector<std::string>& texts);

  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> texts_;
  std::vector<std::vector<Mind>> minds_;
  std::map<std::uint32_t, std::vector<std::string>>
      chosen_;  // by the agents' numbers, in this tick
};

/// The page of one test. `title` is shown above it, `twin`, the same test with the healthy AV,
/// behind it, faintly.
[[nodiscard]] std::string render_player(const std::string& title, const GroundPlan& plan,
                                        const Recording& recording, const MindRecorder& minds,
                                        const std::optional<Recording>& twin = {});

/// `election, 3 agents, seed 0, test 5`.
[[nodiscard]] std::string name_of(const ResultsReader& store, const StoredTest& test);

/// The recording of the same test with the healthy AV; nothing if the test has no defect.
[[nodiscard]] Result<std::optional<Recording>> twin_recording(const ResultsReader& store,
                                                              const StoredTest& test);

/// Runs the test again to record all beliefs and intentions. Error: its result differs from the
/// stored one.
[[nodiscard]] Result<std::string> replay_page(const ResultsReader& store, const StoredTest& test);

/// The first tick at which an actor's place or speed differs; nothing if the runs are alike, or
/// only one of them goes on. REQUIRES: the same actors.
[[nodiscard]] std::optional<std::size_t> parting(const Recording& left, const Recording& right);

/// Two runs of one test, with the healthy AV and with a defective one, as text for a terminal: a
/// line for each tick from the one before they part, with both runs: the AV's place (m along its
/// way), its speed (m/s), the places of the most important actors (m across and along) and the
/// events up to then. `name`: the defective AV's name.
[[nodiscard]] std::string side_by_side(const Recording& healthy, const Recording& defective,
                                       std::string_view name);

}  // namespace jaywalk
