// SPDX-License-Identifier: Apache-2.0
#include "tests/helpers/programs.h"

#include <cstdio>
#include <cstdlib>

#include "interpreter/syntax/load.h"
#include "interpreter/term/print.h"

namespace jaywalk::test {
namespace {

// A test whose own text is wrong cannot say anything.
void require(bool fine, const std::string& why, const CompiledProgram& made) {
  if (fine) return;
  std::fprintf(stderr, "%s:\n%s\n", why.c_str(), made.errors().c_str());
  std::abort();
}

}  // namespace

CompiledProgram::CompiledProgram(std::string_view text, const CompileOptions& options,
                                 Files files) {
  IncludePath include_path;
  include_path.given = std::move(files);
  const auto source = std::make_shared<const Source>("agent.asl", std::string(text));
  const SourceTree tree = load_agent(source, include_path, diagnostics);
  program = compile(tree, symbols, diagnostics, options);
}

std::vector<std::shared_ptr<const Plan>> CompiledProgram::plans() const {
  require(program != nullptr, "the program has errors", *this);
  std::vector<std::shared_ptr<const Plan>> own;
  for (const auto& plan : program->library().plans()) {
    if (!plan->is_standard) own.push_back(plan);
  }
  return own;
}

const Plan& CompiledProgram::plan() const {
  require(plans().size() == 1, "not a program with one plan", *this);
  return *plans().front();
}

std::vector<std::string> CompiledProgram::beliefs() const {
  require(program != nullptr, "the program has errors", *this);
  std::vector<std::string> texts;
  for (const Program::Belief& belief : program->beliefs()) {
    texts.push_back(text(belief.rule == nullptr ? belief.fact : belief.rule->source));
  }
  return texts;
}

std::string CompiledProgram::text(Value term) const { return term_text(term, symbols); }

std::string CompiledProgram::errors() const {
  std::string all;
  for (const Diagnostic& each : diagnostics.items()) {
    if (each.severity != Severity::error) continue;
    const auto at = each.where.source->position(each.where.span.begin);
    all += std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + each.message;
    if (!each.hint.empty()) all += " [" + each.hint + "]";
    all += '\n';
  }
  return all;
}

}  // namespace jaywalk::test
