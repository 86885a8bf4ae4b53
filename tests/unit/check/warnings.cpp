#include "tests/unit/check/warnings.h"

#include <memory>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

Diagnostics checked(const std::string& text, const Vocabulary& vocabulary) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("test", text);
  const SourceTree program = load_agent(source, {}, diagnostics);
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
  std::string shown;
  const Diagnostics diagnostics = checked(text, vocabulary);
  for (const Diagnostic& item : diagnostics.items()) {
    if (item.code == "singleton-variable") continue;
    const auto place = item.where.source->position(item.where.span.begin);
    const std::string hint = item.hint.empty() ? "" : fmt::format(" ({})", item.hint);
    shown += fmt::format("{}: {}: {}{}\n", place.line, item.code, item.message, hint);
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
