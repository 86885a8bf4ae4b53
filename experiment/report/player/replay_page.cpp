#include "experiment/report/player/replay_page.h"

#include <fmt/format.h>

#include "experiment/report/player/player.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/text.h"

namespace jaywalk {

std::string name_of(const ResultsReader& store, const StoredTest& test) {
  const ExperimentDescription& of = store.description();
  std::string name =
      fmt::format("{}, {}, seed {}, test {}", of.behaviours[test.test.behaviour].name,
                  counted(test.test.agents, "agent"), of.seed, test.test.number);
  if (of.vehicles.size() > 1) name += fmt::format(", AV {}", of.vehicles[test.test.vehicle]);
  return name;
}

Result<std::optional<Recording>> twin_recording(const ResultsReader& store,
                                                const StoredTest& test) {
  if (test.test.vehicle == 0) return std::optional<Recording>();
  auto twin = store.recording(twin_id(store.description(), test.test));
  if (!twin) return std::move(twin.diagnostics());
  return std::optional<Recording>(std::move(twin).value());
}

Result<std::string> replay_page(const ResultsReader& store, const StoredTest& test) {
  auto prepared = store.prepared();
  if (!prepared) return std::move(prepared.diagnostics());
  Recording recording;
  MindRecorder minds;
  TestOptions options;
  options.record = &recording;
  options.observer = &minds;
  options.observe = [&](const World&, const Mas& mas) { minds.observe(mas); };
  auto result = store.rerun(test.id, options);
  if (!result) return std::move(result.diagnostics());
  const auto twin = twin_recording(store, test);
  if (!twin) return twin.diagnostics();
  return render_player(name_of(store, test), prepared.value()->scenario().world->plan(), recording,
                       minds, twin.value());
}

}  // namespace jaywalk
