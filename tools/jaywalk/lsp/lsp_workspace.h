// SPDX-License-Identifier: Apache-2.0
#pragma once

// The programs of an editor's folders, as they are on the disk or, where they are open, in the
// editor: where else a name is used that means the same.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tools/jaywalk/lsp/lsp_document.h"

namespace jaywalk::lsp {

/// More programs are not read, and more files and folders not looked at.
inline constexpr std::size_t kMostPrograms = 5000;
inline constexpr std::size_t kMostEntries = 200'000;

/// A name: of a goal, belief, action or internal action, with its number of arguments.
struct Name {
  Use::What what = Use::What::belief;
  std::string text;
  int arity = 0;

  explicit Name(const Use& use) : what(use.what), text(use.name), arity(use.arity) {}
};

struct Folders {
  /// With all folders in them.
  std::set<std::string> whole;
  /// Without: an editor without a workspace may be anywhere.
  std::set<std::string> alone;
};

/// The file on the disk that has a source's name: an installed program, $jaywalk/..., is where
/// the installation has it.
[[nodiscard]] std::string file_of(const std::string& name, const SourceFiles& files);
/// The name $jaywalk/... of a file, if it is installed; else an empty text.
[[nodiscard]] std::string installed_name(const std::string& file, const SourceFiles& files);

/// All programs that are there when it is made.
class Workspace {
 public:
  /// Reads the programs of the folders, and `open` ones, by their paths.
  Workspace(const Folders& folders, const std::vector<std::string>& open,
            const IncludePath& include_path);

  /// The places of a name that is used in a file, in the files where it means the same: those of
  /// programs that both are part of, by way of further ones, too. What agents tell each other or
  /// ask each other for means the same in all programs. By path, of the file on the disk, and
  /// place.
  [[nodiscard]] std::vector<Place> uses(const Name& name, const std::string& path,
                                        Definitions definitions) const;
  /// Whether those programs use the name as something else already, as it would be with that text.
  [[nodiscard]] bool is_taken(const Name& name, std::string_view text,
                              const std::string& path) const;

 private:
  struct Program {
    SourceTree tree;
    std::vector<Use> uses;
  };

  [[nodiscard]] std::string file_of(const Use& use) const;
  void read(const std::string& path, const IncludePath& include_path);
  [[nodiscard]] std::set<std::string> files_of(const Name& name, const std::string& path) const;

  SourceFiles files_;
  std::map<std::string, Program> programs_;  // by path
};

}  // namespace jaywalk::lsp
