// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lets SQLite work on a file that has no name: one that is open already, known by its descriptor.
// For one connection that makes a new file, without journal or locks; other files of the connection
// (attached ones, temporary ones) are opened as always. See https://sqlite.org/vfs.html.

#include <string>

namespace jaywalk {

/// The name by which SQLite opens such a file, and the name of the VFS (SQLite's layer for files)
/// that can open it. Null if SQLite could not register the VFS.
[[nodiscard]] std::string descriptor_name(int descriptor);
[[nodiscard]] const char* descriptor_vfs();

}  // namespace jaywalk
