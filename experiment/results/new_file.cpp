#include "experiment/results/new_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "experiment/export/temporary.h"
#include "experiment/results/store_file.h"

namespace jaywalk {

std::optional<Diagnostics> create_store_file(const std::string& path,
                                             const std::function<void(Database& database)>& fill) {
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    return store_error(path, "the file exists", "choose another name, or remove it first");
  }
  const std::string temporary = make_part_of(path);
  std::optional<std::string> failure;
  if (temporary.empty()) {
    failure = std::generic_category().message(errno);
    return store_error(path, fmt::format("cannot be written: {}", *failure));
  }
  {
    Database database(temporary, Database::Mode::write);
    // Larger pages than SQLite's own make rows of this size cheaper to write.
    database.execute("PRAGMA page_size = 16384");
    database.execute("BEGIN");
    fill(database);
    database.execute("COMMIT");
    if (database.failure()) failure = trouble_with(database);
  }
  // A link, unlike a renamed file, takes no other file's place.
  if (!failure && ::link(temporary.c_str(), path.c_str()) != 0) {
    failure = std::generic_category().message(errno);
  }
  std::filesystem::remove(temporary, error);
  std::filesystem::remove(temporary + "-journal", error);
  if (!failure) return std::nullopt;
  return store_error(path, fmt::format("cannot be written: {}", *failure));
}

}  // namespace jaywalk
