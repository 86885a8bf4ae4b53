// SPDX-License-Identifier: Apache-2.0
#pragma once

// Stored tests as files that other programs read: the rows of exporters.def. To add one: write a
// function in a file of its own, and a row.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/results/reader.h"

namespace jaywalk {

/// Which player an OpenSCENARIO file is for: any that follows the standard, or CARLA's.
enum class ScenarioDialect { standard, carla };

struct ExportRequest {
  const ResultsReader& store;
  /// Their ids, ascending.
  std::vector<std::int64_t> tests;
  /// Where the files go; it exists.
  std::string folder;
  ScenarioDialect dialect = ScenarioDialect::standard;
  /// For `postgis`: the connection for `ogr2ogr`, the schema for the tables (empty: named after the
  /// store), and whether existing tables may be replaced.
  std::string connection;
  std::string schema;
  bool overwrite = false;
};

struct Exported {
  /// The written files, in the order of writing.
  std::vector<std::string> files;
  /// Warnings about parts of the tests that the format cannot express.
  Diagnostics warnings;
  /// A hint for programs that read them; usually empty.
  std::string note = {};
};

/// Errors: the store cannot be read, a file cannot be written.
using ExportedFiles = Result<Exported>;

struct Exporter {
  std::string_view name;
  std::string_view summary;
  ExportedFiles (*run)(const ExportRequest&);
};

[[nodiscard]] std::span<const Exporter> exporters();
/// Null if there is none of that name.
[[nodiscard]] const Exporter* find_exporter(std::string_view name);

/// The name of a test's files, without an ending: `proximity-10-test-7`.
[[nodiscard]] std::string file_stem(const ResultsReader& store, const TestKey& test);

/// Writes a file of the export and notes it down.
[[nodiscard]] bool write_export(const ExportRequest& request, const std::string& name,
                                std::string_view text, std::vector<std::string>& written,
                                Diagnostics& diagnostics);
/// Writes a file of the export piece by piece; a source that fails reports it in the diagnostics.
[[nodiscard]] bool write_export(const ExportRequest& request, const std::string& name,
                                const TextSource& source, std::vector<std::string>& written,
                                Diagnostics& diagnostics);

#define JAYWALK_EXPORTER(name, function, summary) \
  [[nodiscard]] ExportedFiles function(const ExportRequest& request);
#include "experiment/export/exporters.def"
#undef JAYWALK_EXPORTER

/// Runs another program to its end: its exit status; 127 if there is none of that name. What it
/// writes to standard output is added to `output`, if there is one.
[[nodiscard]] int run_program(std::vector<std::string> words, std::string* output = nullptr);

}  // namespace jaywalk
