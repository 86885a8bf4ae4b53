// SPDX-License-Identifier: Apache-2.0
#pragma once

// Opens a store only after it was seen to be one: a foreign or damaged file is distinguished from a
// store before SQLite, which could change it, is let near it.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "experiment/results/description.h"
#include "experiment/results/store/database.h"
#include "experiment/results/store/geopackage.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// How closely a store is looked at: its header and tables, or every page of it.
enum class Scrutiny { header, all };

[[nodiscard]] bool is_store(const std::string& path, const StoreKind& kind);

/// Opens a store for reading. Errors: there is no file, it is no store of this kind, it is damaged
/// or cut off, it has another version, another process is writing it.
[[nodiscard]] Result<std::unique_ptr<Database>> open_to_read(const std::string& path,
                                                             const StoreKind& kind,
                                                             Scrutiny scrutiny);
/// Opens a store for writing, if all of it is sound; no other process can open it until it is
/// closed. Not a byte is changed before start_log().
[[nodiscard]] Result<std::unique_ptr<Database>> open_to_write(const std::string& path,
                                                              const StoreKind& kind);

/// From here on each transaction is appended to a log beside the file, and is kept if the process
/// is killed.
void start_log(Database& database);
/// Makes it one file without a log, which can be read from anywhere. Why that failed, if it did.
[[nodiscard]] std::optional<std::string> finish_log(Database& database, const std::string& path);

/// Why a database could not be used, in words. REQUIRES: it failed.
[[nodiscard]] std::string trouble_with(const Database& database);
[[nodiscard]] Diagnostics store_error(const std::string& path, std::string message,
                                      std::string hint = {});

void write_description(Database& database, const ExperimentDescription& description);
/// Writes the changes that add_judging() made to the description into the store.
void write_judging(Database& database, const ExperimentDescription& before,
                   const ExperimentDescription& now);

/// A results store and the description of its experiment.
struct DescribedStore {
  std::unique_ptr<Database> database;
  ExperimentDescription description;
};

/// Reads the description of an opened store. Errors: those of opening it; the description cannot be
/// read, or makes no sense.
[[nodiscard]] Result<DescribedStore> described(Result<std::unique_ptr<Database>> opened,
                                               const std::string& path);

/// Creates a database of this name by what `fill` does within a transaction: whole, or not at all.
/// No file that is there already is touched. Why that failed, if it did.
[[nodiscard]] std::optional<Diagnostics> create_store_file(
    const std::string& path, const std::function<void(Database& database)>& fill);

}  // namespace jaywalk
