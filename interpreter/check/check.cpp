#include "interpreter/check/check.h"

#include <array>
#include <utility>

#include "interpreter/check/checking.h"

namespace jaywalk {
namespace {

constexpr std::array kChecks = {
#define JAYWALK_CHECK(function, code, summary) CheckInfo{code, summary},
#define JAYWALK_READING(code, summary) CheckInfo{code, summary},
#include "interpreter/check/checks.def"
};

}  // namespace

std::span<const CheckInfo> checks() { return kChecks; }

void check_program(const SourceTree& program, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics) {
  check_program(program, words_of(program), vocabulary, diagnostics);
}

void check_program(const SourceTree& program, ProgramWords words, const Vocabulary& vocabulary,
                   Diagnostics& diagnostics) {
  Checking checking(program, std::move(words), vocabulary);
#define JAYWALK_CHECK(function, code, summary) \
  checking.begin(code);                        \
  function(checking);
#include "interpreter/check/checks.def"
  diagnostics.append(checking.finish());
}

}  // namespace jaywalk
