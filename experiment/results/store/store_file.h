#pragma once

// Opens a store only after it was seen to be one: a foreign or damaged file is distinguished from a
// store before SQLite, which could change it, is let near it.

#include <memory>
#include <optional>
#include <string>

#include "experiment/results/description.h"
#include "experiment/results/store/database.h"

namespace jaywalk {

/// How closely a store is looked at: its header and versions, or every page of it.
enum class Scrutiny { header, all };

struct OpenStore {
  std::unique_ptr<Database> database;
  ExperimentDescription description;
};

/// Opens a store for reading. Errors: there is no file, it is no store, it is damaged or cut off,
/// it has another version, it is in use, its description makes no sense.
[[nodiscard]] Result<OpenStore> open_to_read(const std::string& path, Scrutiny scrutiny);
/// Opens for writing what was seen to be sound and was closed again; nobody else can open it then.
[[nodiscard]] Result<std::unique_ptr<Database>> open_to_write(const std::string& path);

/// Why a file cannot be a store of any kind, by its first bytes: it is no SQLite file, no
/// GeoPackage, cut off; nothing if it can.
[[nodiscard]] std::optional<std::string> why_no_store_file(const std::string& path);

/// Why a database could not be used, in words. REQUIRES: it failed.
[[nodiscard]] std::string trouble_with(const Database& database);
[[nodiscard]] Diagnostics store_error(const std::string& path, std::string message,
                                      std::string hint = {});

void write_description(Database& database, const ExperimentDescription& description);
/// What add_judging() made of the description in the store.
void write_judging(Database& database, const ExperimentDescription& before,
                   const ExperimentDescription& now);
/// Errors: what is there cannot be read, or makes no sense.
[[nodiscard]] Result<ExperimentDescription> read_description(Database& database,
                                                             const std::string& path);

}  // namespace jaywalk
