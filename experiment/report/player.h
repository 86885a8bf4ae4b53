#pragma once

// A test as a page to look at: a player that draws every tick and shows what an agent believes and
// intends. The page needs nothing beside it and no network.

#include <map>
#include <string>
#include <vector>

#include "env/crossing/crossing.h"
#include "experiment/recording.h"
#include "interpreter/mas/mas.h"

namespace jaywalk {

/// What the agents had in mind, tick by tick. Give its `observe` to a trial.
class MindRecorder {
 public:
  struct Mind {
    /// Indices into texts().
    std::vector<std::size_t> intentions;
    std::vector<std::size_t> beliefs;
  };

  void observe(const Mas& mas);

  /// For each tick, each agent's.
  [[nodiscard]] const std::vector<std::vector<Mind>>& minds() const { return minds_; }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::vector<std::size_t> intern(const std::vector<std::string>& texts);

  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> texts_;
  std::vector<std::vector<Mind>> minds_;
};

/// The page of one test. `title` is shown above it.
[[nodiscard]] std::string render_player(const std::string& title,
                                        const CrossingParameters& parameters,
                                        const Recording& recording, const MindRecorder& minds);

}  // namespace jaywalk
