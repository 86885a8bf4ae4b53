#pragma once

// Whether a database has the tables that it should have, and nothing that does something by itself:
// looked at before anything is read of a file that may come from anywhere.

#include <functional>
#include <optional>
#include <string>

#include "experiment/results/store/database.h"

namespace jaywalk {

/// The version of GeoPackage that stores have, 1.3, in a SQLite file's `user_version`.
inline constexpr std::int64_t kGeoPackageVersion = 10300;

/// Makes all that a database of that kind may have beside tables of others.
using CreateTables = std::function<void(Database&)>;

/// Why it has more than that: a view, a trigger, a virtual table, an index. Tables that others have
/// added (styles of a GIS) are ignored.
[[nodiscard]] std::optional<std::string> foreign_object(Database& database,
                                                        const CreateTables& create);

/// Why its tables are not those that `create` makes, each column as it makes it.
[[nodiscard]] std::optional<std::string> table_difference(Database& database,
                                                          const CreateTables& create);

}  // namespace jaywalk
