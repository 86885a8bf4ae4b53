#include "experiment/report/replay_page.h"

#include <fmt/format.h>

#include "experiment/report/player.h"

namespace jaywalk {

std::string name_of(const ResultsReader& store, const StoredTest& test) {
  return fmt::format("{}, {} agent{}, seed {}, test {}",
                     store.description().behaviours[test.test.behaviour].name, test.test.agents,
                     test.test.agents == 1 ? "" : "s", store.description().seed, test.test.number);
}

Result<std::string> replay_page(const ResultsReader& store, const StoredTest& test) {
  auto prepared = store.prepared();
  if (!prepared) return std::move(prepared.diagnostics());
  Recording recording;
  MindRecorder minds;
  TrialOptions options;
  options.record = &recording;
  options.observer = &minds;
  options.observe = [&](const Crossing&, const Mas& mas) { minds.observe(mas); };
  auto result = store.rerun(test.id, options);
  if (!result) return std::move(result.diagnostics());
  return render_player(name_of(store, test), prepared.value()->scenario().world, recording, minds);
}

}  // namespace jaywalk
