// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads an agent's program with everything that it includes, before it is checked and compiled.

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "interpreter/support/source_files.h"
#include "interpreter/syntax/ast.h"

namespace jaywalk {

/// The code of the warning that an included file is missing, which leaves it out, as in Jason; and
/// what to do about it where that is an error.
inline constexpr std::string_view kMissingInclude = "missing-include";
inline constexpr std::string_view kMissingIncludeHint =
    "`// jaywalk: allow missing-include` in the line before runs without it";

/// The folders in which included files are searched for, after the folder of the including file.
struct IncludePath {
  /// Folders that a project names, in order (`aslSourcePath`). Of those that lie outside what its
  /// programs may read (SourceFiles::readable_from), nothing is.
  std::vector<std::string> source_path;
  /// Folders that the user names, after those (`--include`).
  std::vector<std::string> folders;
  /// Prefixes and what stands for them: `$jasonJar` → a folder (`--map`).
  std::vector<std::pair<std::string, std::string>> mapped;
  /// Texts that stand for files: those of a name, in whatever folder, or the one of a path (a/b).
  std::vector<std::pair<std::string, std::string>> given;

  /// The folders that a program in `folder` may read.
  [[nodiscard]] AllowedFolders readable_from(const std::string& folder) const;
  /// The text given for a file; null if the file must be searched for.
  [[nodiscard]] const std::string* given_text(std::string_view path) const;
  /// The program's own file, if the loaded text only adds to it (options of a project): an error in
  /// it is an error of the program, not of an include.
  std::string program;
  /// The source of files: the disk, unless copies are given.
  SourceFiles files;
};

/// A program's files. The first is the program itself; an include directive leads to another.
/// Files are in the order in which they were first included; each is parsed once per inclusion.
struct SourceTree {
  std::vector<std::unique_ptr<ast::File>> files;
  /// The file that each `include` directive (by its component's address) stands for. An include
  /// that could not be read has no entry; its diagnostic has been added.
  std::unordered_map<const ast::Component*, const ast::File*> includes;
  /// The number of errors in included files that are left out. As in Jason, the program can be run
  /// without these files.
  std::size_t left_out_errors = 0;

  [[nodiscard]] const ast::File& main() const { return *files.front(); }
};

/// Includes nested deeper than this, or more in number, are refused (a file that includes itself).
inline constexpr int kMaxIncludeDepth = 64;
inline constexpr int kMaxIncludedFiles = 1000;

/// Reads and parses the program at `path`. Always returns a tree with at least one file; whether it
/// can be used, the diagnostics say why. A missing include is a warning, as in Jason.
[[nodiscard]] SourceTree load_agent(const std::string& path, const IncludePath& include_path,
                                    Diagnostics& diagnostics);

/// Reads and parses a program whose text is in memory already; includes are relative to the
/// source's name.
[[nodiscard]] SourceTree load_agent(SourcePtr source, const IncludePath& include_path,
                                    Diagnostics& diagnostics);

}  // namespace jaywalk
