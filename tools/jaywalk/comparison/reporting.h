// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reports as commands make them: of a store, or of a comparison that no store keeps.

#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/kills/kills_file.h"
#include "experiment/report/report.h"
#include "experiment/results/reader.h"
#include "tools/jaywalk/console/console.h"

namespace jaywalk {

enum class ReplayPages { none, beside };

/// The page of a store of tests or of searches; nothing after reporting why there is none. With
/// `beside`, pages that play the tests it names are written into a folder named after `html`; the
/// tests are run again for it. The kill matrix has `other_kills`, too.
[[nodiscard]] std::optional<std::string> stored_report(
    const std::string& store, const std::string& html, ReplayPages pages, Commands commands,
    Console& console, const std::vector<KillLine>& other_kills = {});

/// The data of a comparison without a store, for its report.
struct UnstoredTests {
  const Comparison& comparison;
  ExperimentDescription description;
  std::shared_ptr<const PreparedScenario> prepared;
  const Criteria& criteria;
  const reporting::FactsTable& facts;
};
[[nodiscard]] std::string unstored_report(const UnstoredTests& tests);

}  // namespace jaywalk
