#pragma once

// Puts the stores of an experiment's shards together. The result does not depend on the order in
// which they are named.

#include <cstdint>
#include <string>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

struct MergeOutcome {
  std::uint64_t tests = 0;
  /// How many the whole experiment has.
  std::uint64_t planned = 0;
};

/// Writes a new store with the tests of all `inputs`, each once; the inputs stay as they are. The
/// new one describes the whole experiment: missing tests can be run with --resume. Errors: `output`
/// exists, an input is no store or is damaged, two hold different experiments or levels, or the
/// same test with different outcomes.
[[nodiscard]] Result<MergeOutcome> merge_stores(const std::string& output,
                                                const std::vector<std::string>& inputs);

}  // namespace jaywalk
