// SPDX-License-Identifier: Apache-2.0
#pragma once

// Programs that answer lines with lines, as scripts of the shell: what controllers and systems
// under test say. Read target.h first.

#include <string>
#include <string_view>
#include <vector>

#include "tests/helpers/generate.h"

namespace jaywalk::fuzz {

/// The answers, some of them spoilt: other values, two lines or none for one question, bytes that
/// are no JSON.
[[nodiscard]] std::vector<std::string> spoil_answers(test::Choices& choices,
                                                     std::vector<std::string> answers);

/// A script for `sh` that answers each line that does not begin with `unanswered` by the next of
/// these texts, whatever bytes they are made of, and ends behind the last.
[[nodiscard]] std::string answering_script(const std::vector<std::string>& answers,
                                           std::string_view unanswered);

}  // namespace jaywalk::fuzz
