#pragma once

// The functions of the rows of exporters.def.

#include "experiment/export/exporter.h"

namespace jaywalk {

#define JAYWALK_EXPORTER(name, function, summary) \
  [[nodiscard]] ExportedFiles function(const ExportRequest& request);
#include "experiment/export/exporters.def"
#undef JAYWALK_EXPORTER

}  // namespace jaywalk
