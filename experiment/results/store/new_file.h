#pragma once

#include <functional>
#include <optional>
#include <string>

#include "experiment/results/store/database.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Creates a database of this name by what `fill` does within a transaction: whole, or not at all.
/// No file that is there already is touched. Why that failed, if it did.
[[nodiscard]] std::optional<Diagnostics> create_store_file(
    const std::string& path, const std::function<void(Database& database)>& fill);

}  // namespace jaywalk
