// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/check/warnings.h"

#include <memory>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

constexpr std::string_view kMain = "test";

Diagnostics checked(const std::string& text, const Vocabulary& vocabulary,
                    const Included& included = {}) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>(std::string(kMain), text);
  const SourceTree program = load_agent(source, {.given = included}, diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << diagnostics.render();
  check_program(program, vocabulary, diagnostics);
  return diagnostics;
}

}  // namespace

Vocabulary nothing_known() {
  Vocabulary vocabulary;
  vocabulary.may_be_alone = false;
  return vocabulary;
}

std::string warnings_of(const std::string& text, const Vocabulary& vocabulary) {
  return warnings_with({}, text, vocabulary);
}

std::string warnings_with(const Included& included, const std::string& text,
                          const Vocabulary& vocabulary) {
  std::string shown;
  const Diagnostics diagnostics = checked(text, vocabulary, included);
  for (const Diagnostic& item : diagnostics.items()) {
    if (item.code == "singleton-variable") continue;
    const Source& source = *item.where.source;
    if (source.name() != kMain) shown += source.name() + ":";
    const std::string hint = item.hint.empty() ? "" : fmt::format(" ({})", item.hint);
    shown += fmt::format("{}: {}: {}{}\n", source.position(item.where.span.begin).line, item.code,
                         item.message, hint);
  }
  return shown;
}

std::string warnings_of(std::string_view code, const std::string& text,
                        const Vocabulary& vocabulary) {
  std::string shown;
  const Diagnostics diagnostics = checked(text, vocabulary);
  for (const Diagnostic& item : diagnostics.items()) {
    if (item.code != code) continue;
    const auto place = item.where.source->position(item.where.span.begin);
    shown += fmt::format("{}:{} {}\n", place.line, place.column, item.message);
  }
  return shown;
}

}  // namespace jaywalk
