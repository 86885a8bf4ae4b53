#pragma once

// Lets SQLite work on a file that has no name: one that is open already, known by its descriptor.
// For one connection that makes a new file, without journal or locks; other files of the connection
// (attached ones, temporary ones) are opened as always. See https://sqlite.org/vfs.html.

#include <string>

namespace jaywalk {

/// What to open such a file by, and the name of the VFS (SQLite's way to the system) that can.
/// Null if SQLite could not take note of it.
[[nodiscard]] std::string descriptor_name(int descriptor);
[[nodiscard]] const char* descriptor_vfs();

}  // namespace jaywalk
