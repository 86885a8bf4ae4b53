// SPDX-License-Identifier: Apache-2.0
#pragma once

// What strangers may have done to a store: other values, rows, tables, views and bytes. Read
// target.h first.

#include <string>

#include "tests/fuzz/target.h"
#include "tests/helpers/generate.h"

namespace jaywalk::fuzz {

/// A store after a change.
struct ChangedStore {
  std::string bytes;
  /// The statements that changed it, or which bytes were.
  std::string how;
};

/// The path of the store.gpkg that a case makes when it runs, a sound one; made once for each
/// `name`.
[[nodiscard]] std::string sound_store(const std::string& name, const Case& maker);

/// Some change of the database in the file `path`, which stays as it is. `sql` begins the
/// statements; they may fail.
[[nodiscard]] ChangedStore change_store(test::Choices& choices, const std::string& path,
                                        const std::string& sql);

}  // namespace jaywalk::fuzz
