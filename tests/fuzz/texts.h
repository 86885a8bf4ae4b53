// SPDX-License-Identifier: Apache-2.0
#pragma once

// The texts that cases begin with, and the ways in which they are spoilt. Read target.h first.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/helpers/generate.h"

namespace jaywalk::fuzz {

using test::Choices;

using Texts = std::vector<std::string>;

/// The files of tests/fuzz/corpus/<target>, in the order of their names.
[[nodiscard]] Texts corpus(std::string_view target);
/// The project's own files below `folder` whose names end in `ending`, in the order of their paths.
[[nodiscard]] Texts project_texts(std::string_view folder, std::string_view ending);
/// A pedestrian's program, `walker.asl`, and what it and others of its folder include, by names.
[[nodiscard]] std::map<std::string, std::string> walker_files();
/// One of the project's own files.
[[nodiscard]] std::string project_text(std::string_view path);

[[nodiscard]] const std::string& one_of(Choices& choices, const Texts& texts);

/// `text` with some runs of tokens replaced by runs of `donor`'s. A run often is a whole group in
/// brackets or ends with a full stop, so that much of what comes out is well formed.
[[nodiscard]] std::string splice(Choices& choices, std::string_view text, std::string_view donor);

/// A YAML text with lines dropped, doubled, moved or indented, and values replaced by odd ones or
/// by those of `donor`.
[[nodiscard]] std::string spoil_yaml(Choices& choices, std::string_view text,
                                     std::string_view donor);

/// A JSON text with values replaced by odd ones, members dropped or doubled. What is not JSON is
/// changed as bytes.
[[nodiscard]] std::string spoil_json(Choices& choices, const std::string& text);

/// A scalar that few readers expect: numbers beyond their types, empty and strange words.
[[nodiscard]] std::string_view odd_scalar(Choices& choices);

}  // namespace jaywalk::fuzz
