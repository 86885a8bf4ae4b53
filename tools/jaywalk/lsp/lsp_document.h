// SPDX-License-Identifier: Apache-2.0
#pragma once

// An open document: its text, its diagnostics, and the answers to an editor's requests about it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/check.h"
#include "interpreter/check/index/lsp_names.h"
#include "interpreter/support/diagnostics.h"
#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {

struct Completion {
  std::string label;
  std::string detail;
  Use::What what = Use::What::belief;
};

/// A place in a file of the program, perhaps another than the document.
struct Place {
  std::string path;
  Range range;
};

enum class Definitions : std::uint8_t { left_out, included };

class Document {
 public:
  Document(std::string uri, SourcePtr source, const IncludePath& include_path);

  [[nodiscard]] const std::string& uri() const { return uri_; }
  [[nodiscard]] const SourcePtr& source() const { return source_; }
  [[nodiscard]] const TextPlaces& places() const { return places_; }
  [[nodiscard]] bool is_program() const { return !is_project_; }
  /// Diagnostics of the document itself, and the first error of its includes.
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  [[nodiscard]] std::span<const ast::Component> components() const;

  /// Markdown, with the place that it is about; nothing if there is nothing to say.
  [[nodiscard]] std::optional<std::pair<std::string, Range>> hover(Position at) const;
  /// The completions for a name that is being written, and the range of its text so far.
  [[nodiscard]] std::vector<Completion> completions(Position at, Range& written) const;
  [[nodiscard]] std::vector<Place> definitions(Position at) const;
  /// The use of a name at a place; null if there is none.
  [[nodiscard]] const Use* use_there(Position at) const;
  /// The name at a place, if it can be renamed: a goal's or a belief's.
  [[nodiscard]] std::optional<Place> renamable(Position at) const;
  /// A word of the environment that the program seems to be written for, which is not its to
  /// rename.
  [[nodiscard]] bool is_of_environment(const Use& use) const;
  /// Whether that file is part of the program, or may be one that an include did not find.
  [[nodiscard]] bool depends_on(std::string_view path) const;

 private:
  void analyse_program(const IncludePath& include_path);
  [[nodiscard]] Place place_of(const Use& use) const;
  [[nodiscard]] std::string goal_text(const Use& goal) const;

  std::string uri_;
  bool is_project_;
  SourcePtr source_;
  TextPlaces places_;
  std::vector<Diagnostic> diagnostics_;
  SourceTree program_;
  bool misses_include_ = false;
  std::vector<Use> uses_;
};

/// Whether a goal or belief can have this name.
[[nodiscard]] bool is_good_name(std::string_view name);

}  // namespace jaywalk::lsp
