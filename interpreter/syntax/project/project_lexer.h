// SPDX-License-Identifier: Apache-2.0
// The words of a project file (.mas2j), as Jason's MAS2JParser.jcc reads them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

enum class ProjectTokenKind : std::uint8_t {
  end_of_text,
  word,
  number,
  string,  // with its quotes
  path,    // the folders of a path, up to and with the last slash
  symbol,
  bad,  // already diagnosed
};

struct ProjectToken {
  ProjectTokenKind kind = ProjectTokenKind::end_of_text;
  Span span;
  std::string_view text;
};

/// Up to the '}' that closes the project, as Jason reads; the last token is end_of_text. The
/// tokens' texts are the source's.
[[nodiscard]] std::vector<ProjectToken> project_tokens(const SourcePtr& source,
                                                       Diagnostics& diagnostics);

}  // namespace jaywalk
