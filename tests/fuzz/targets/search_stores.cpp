// SPDX-License-Identifier: Apache-2.0
// Stores of searches that were changed.
#include "tests/fuzz/store_changes.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::search_stores {
namespace {

constexpr std::string_view kSearch =
    "sut: {kind: lane-keeping, controller: paper-rate, speed_limit_kmh: 300, tolerance: 0.95}\n"
    "fitness: {measure: max_oob, fails_at: 0.95}\nbudget: {tests: 4, virtual_s: 0}\n"
    "generators: [random]\nrepetitions: 2\nseed: 1\n";

std::map<std::string, std::string> search_inputs() {
  return {{"search.yaml", std::string(kSearch)}};
}

std::vector<std::string> search(const std::string& mode) {
  std::vector<std::string> words = {"search",  "search.yaml", "--threads", "1",
                                    "--quiet", "--store",     "store.gpkg"};
  if (!mode.empty()) words.push_back(mode);
  return words;
}

Case search_case() {
  return {.files = search_inputs(), .agents = {}, .commands = {search("")}, .input = {}};
}

}  // namespace

Case make(Choices& choices) {
  ChangedStore store = change_store(choices, sound_store("search_stores", search_case()), {});
  Case made{.files = search_inputs(), .agents = {}, .commands = {}, .input = {}};
  made.files["store.gpkg"] = std::move(store.bytes);
  made.files["how.sql"] = std::move(store.how);
  made.commands = {{"report", "store.gpkg", "--html", "page.html"}};
  if (choices.once_in(2)) made.commands.insert(made.commands.begin(), search("--resume"));
  made.outputs = {"store.gpkg", "page"};
  return made;
}

}  // namespace jaywalk::fuzz::target::search_stores
