// SPDX-License-Identifier: Apache-2.0
#pragma once

// Percepts that come as texts. Each text is read once, so that most percepts of a tick cost a look
// into a table.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "interpreter/term/symbol.h"
#include <jaywalk/environment.h>

namespace jaywalk {

/// A literal without its annotations. Percepts with equal contents are one percept.
struct PerceptContent {
  /// For whoever goes through several lists and wants to see each content once.
  std::uint64_t mark = 0;
};

struct Percept {
  GroundLiteral literal;
  std::shared_ptr<PerceptContent> content;
};
using PerceptPtr = std::shared_ptr<const Percept>;

class PerceptTexts {
 public:
  explicit PerceptTexts(SymbolTable& symbols) : symbols_(symbols) {}

  /// The percept of a text; null after adding to `problems`, in which the text has the name `of`
  /// ("a percept of robot").
  [[nodiscard]] PerceptPtr read(const std::string& text, const std::string& of,
                                Diagnostics& problems);

  /// How many texts are kept.
  [[nodiscard]] std::size_t size() const { return by_text_.size(); }

 private:
  void forget_unused();

  SymbolTable& symbols_;
  std::unordered_map<std::string, PerceptPtr> by_text_;
  /// By the texts as we would write them, without annotations.
  std::unordered_map<std::string, std::shared_ptr<PerceptContent>> contents_;
  std::size_t most_texts_ = 0;
};

}  // namespace jaywalk
