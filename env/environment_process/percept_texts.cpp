// SPDX-License-Identifier: Apache-2.0
#include "env/environment_process/percept_texts.h"

#include <algorithm>
#include <utility>

#include "env/environment_process/environment_messages.h"

namespace jaywalk {
namespace {

/// So many texts are kept at least, used or not.
constexpr std::size_t kFewTexts = 10'000;

}  // namespace

PerceptPtr PerceptTexts::read(const std::string& text, const std::string& of,
                              Diagnostics& problems) {
  if (const auto known = by_text_.find(text); known != by_text_.end()) return known->second;
  auto literal = GroundLiteral::read(symbols_, of, text);
  if (!literal) {
    problems.append(std::move(literal.diagnostics()));
    return nullptr;
  }
  const GroundLiteral& read = literal.value();
  auto& content = contents_[literal_text(read.predicate(), read.args(), symbols_)];
  if (content == nullptr) content = std::make_shared<PerceptContent>();
  auto percept = std::make_shared<const Percept>(Percept{std::move(literal.value()), content});
  if (by_text_.size() >= std::max(most_texts_, kFewTexts)) forget_unused();
  by_text_.emplace(text, percept);
  return percept;
}

void PerceptTexts::forget_unused() {
  std::erase_if(by_text_, [](const auto& each) { return each.second.use_count() == 1; });
  std::erase_if(contents_, [](const auto& each) { return each.second.use_count() == 1; });
  most_texts_ = 2 * by_text_.size();
}

}  // namespace jaywalk
