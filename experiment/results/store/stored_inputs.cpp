#include "experiment/results/store/stored_inputs.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "experiment/scenario/files/program_text.h"

namespace jaywalk {

StoredInput stored_input(const Source& source) {
  return {
      .path = source.name(), .text = std::string(source.text()), .sha256 = sha256(source.text())};
}

std::vector<StoredInput> stored_inputs(std::span<const SourcePtr> sources) {
  std::vector<StoredInput> inputs;
  for (const SourcePtr& source : sources) inputs.push_back(stored_input(*source));
  return inputs;
}

SourceFiles copies_of(std::span<const StoredInput> inputs) {
  std::vector<SourcePtr> copies;
  for (const StoredInput& input : inputs) {
    copies.push_back(std::make_shared<const Source>(input.path, input.text));
  }
  return SourceFiles(copies);
}

void write_inputs(Database& database, std::span<const StoredInput> inputs) {
  Statement input(database, "INSERT INTO inputs (path, sha256, text) VALUES (?, ?, ?)");
  for (const StoredInput& each : inputs) input.run(each.path, each.sha256, each.text);
}

std::vector<StoredInput> read_inputs(Database& database) {
  std::vector<StoredInput> inputs;
  Statement input(database, "SELECT path, sha256, text FROM inputs ORDER BY id");
  while (input.step()) {
    inputs.push_back({.path = input.text(0), .text = input.text(2), .sha256 = input.text(1)});
  }
  return inputs;
}

std::optional<std::string> damage_of(std::span<const StoredInput> inputs) {
  const auto changed = std::ranges::find_if(
      inputs, [](const StoredInput& stored) { return sha256(stored.text) != stored.sha256; });
  if (changed == inputs.end()) return std::nullopt;
  return fmt::format("the store is damaged: the text of '{}' is not the one whose hash it has",
                     changed->path);
}

}  // namespace jaywalk
