// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files of programs to start processes from, made from kept copies of their texts: a stored test
// runs with the controller that it ran with, even if the original file has changed since.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiment/scenario/files/temporary.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/support/source_files.h"

namespace jaywalk {

/// Files in a folder of their own, which goes when this does.
class ProgramCopies {
 public:
  /// The name of a new file with this text, executable by us alone. Error: it cannot be written.
  [[nodiscard]] Result<std::string> add(const Source& program);

 private:
  TemporaryFolder folder_;
  int count_ = 0;
};

/// The words of commands that are text files: `sources` gets their texts. A word whose file is not
/// (or no longer) what `files` has is replaced by the name of a copy, which lasts as long as the
/// result; null if none is needed.
[[nodiscard]] Result<std::shared_ptr<const ProgramCopies>> keep_programs(
    std::span<std::vector<std::string>* const> commands, const SourceFiles& files,
    std::vector<SourcePtr>& sources);

}  // namespace jaywalk
