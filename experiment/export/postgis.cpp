// The store in a PostGIS database: GDAL's ogr2ogr knows how, if it is there.

#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "experiment/export/exporters.h"
#include "experiment/export/program.h"

namespace jaywalk {
ExportedFiles export_postgis(const ExportRequest& request) {
  Diagnostics diagnostics;
  if (request.connection.empty()) {
    diagnostics.error("--connection", "says which database the tables go to",
                      "as ogr2ogr wants it, 'dbname=tests host=localhost'");
    return diagnostics;
  }
  const int status =
      run_program({"ogr2ogr", "-f", "PostgreSQL", "PG:" + request.connection, request.store.path(),
                   "-overwrite", "-lco", "GEOMETRY_NAME=geom"});
  if (status == 127) {
    diagnostics.error("ogr2ogr", "is not installed", "it is in Debian's package gdal-bin");
  } else if (status != 0) {
    diagnostics.error("ogr2ogr", fmt::format("failed with exit status {}", status));
  }
  if (diagnostics.has_errors()) return diagnostics;
  return std::vector<std::string>{"PG:" + request.connection};
}

}  // namespace jaywalk
