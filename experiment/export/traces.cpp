// SPDX-License-Identifier: Apache-2.0
// Each test as a table that `jaywalk judge --trace` reads.

#include "experiment/export/exporter.h"
#include "experiment/judge/trace_file.h"

namespace jaywalk {

ExportedFiles export_trace(const ExportRequest& request) {
  Exported exported;
  Diagnostics diagnostics;
  for (const std::int64_t id : request.tests) {
    const Result<StoredTest> test = request.store.test(id);
    if (!test.ok()) return test.diagnostics();
    const Result<Recording> recording = request.store.recording(id);
    if (!recording.ok()) return recording.diagnostics();
    const std::string name = file_stem(request.store, test.value().test) + ".csv";
    const std::string text = print_trace(recording.value());
    if (!write_export(request, name, text, exported.files, diagnostics)) return diagnostics;
  }
  return exported;
}

}  // namespace jaywalk
