#include "experiment/results/store/new_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "experiment/results/store/store_file.h"
#include "experiment/scenario/files/temporary.h"

namespace jaywalk {

namespace {

Diagnostics taken(const std::string& path) {
  return store_error(path, "the file exists", "choose another name, or remove it first");
}

}  // namespace

std::optional<Diagnostics> create_store_file(const std::string& path,
                                             const std::function<void(Database& database)>& fill) {
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    return taken(path);
  }
  PartFile part(path);
  std::optional<std::string> failure;
  if (!part.is_open()) {
    failure = std::generic_category().message(errno);
    return store_error(path, fmt::format("cannot be written: {}", *failure));
  }
  {
    Database database(part.descriptor());
    // Larger pages than SQLite's own make rows of this size cheaper to write.
    database.execute("PRAGMA page_size = 16384");
    database.execute("BEGIN");
    fill(database);
    database.execute("COMMIT");
    if (database.failure()) failure = trouble_with(database);
  }
  if (!failure && !part.put_new()) {
    // Another process may have put its file there while this one was filled.
    if (errno == EEXIST) return taken(path);
    failure = std::generic_category().message(errno);
  }
  if (!failure) return std::nullopt;
  return store_error(path, fmt::format("cannot be written: {}", *failure));
}

}  // namespace jaywalk
