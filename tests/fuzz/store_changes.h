#pragma once

// What strangers may have done to a store: other values, rows, tables, views and bytes. Read
// target.h before.

#include <string>

#include "tests/helpers/generate.h"

namespace jaywalk::fuzz {

/// A store after a change.
struct ChangedStore {
  std::string bytes;
  /// The statements that changed it, or which bytes were.
  std::string how;
};

/// Some change of the database in the file `path`, which stays as it is. `sql` begins the
/// statements; they may fail.
[[nodiscard]] ChangedStore change_store(test::Choices& choices, const std::string& path,
                                        const std::string& sql);

}  // namespace jaywalk::fuzz
