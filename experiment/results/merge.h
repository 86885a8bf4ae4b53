// SPDX-License-Identifier: Apache-2.0
#pragma once

// Stores made of stores: those of an experiment's shards together, whatever the order in which they
// are named; and some tests of one.

#include <cstdint>
#include <optional>
#include <span>
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

/// Copies the store `from` to a new file `to` with the tests of these ids only. The copy keeps the
/// description of the whole experiment; it is for programs that read its tables. Returns why that
/// was not possible.
[[nodiscard]] std::optional<std::string> copy_tests(const std::string& from, const std::string& to,
                                                    std::span<const std::int64_t> ids);

}  // namespace jaywalk
