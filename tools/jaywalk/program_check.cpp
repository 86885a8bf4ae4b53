#include "tools/jaywalk/program_check.h"

#include <filesystem>
#include <system_error>

#include "interpreter/compile/compiler.h"
#include "interpreter/term/symbol.h"
#include "tools/jaywalk/vocabulary.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// Whether a project, of Jason or JaCaMo, lies in the program's folder or above it.
bool lies_in_project(const std::string& path) {
  constexpr int kFolders = 4;
  std::error_code failure;
  fs::path folder = fs::absolute(path, failure).parent_path();
  for (int i = 0; i < kFolders && !failure; ++i, folder = folder.parent_path()) {
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure)) {
      const std::string extension = entry->path().extension().string();
      if (extension == ".mas2j" || extension == ".jcm") return true;
    }
  }
  return false;
}

}  // namespace

void check_loaded(const SourceTree& program, const EnvironmentKind* environment,
                  const std::function<void(Vocabulary&)>& complete, Diagnostics& found) {
  if (!found.has_errors()) {
    SymbolTable symbols;
    (void)compile(program, symbols, found);
  }
  if (found.has_errors()) return;
  Vocabulary vocabulary = vocabulary_for(environment);
  complete(vocabulary);
  check_program(program, vocabulary, found);
}

void check_alone(const SourceTree& program, const std::string& path, Diagnostics& found) {
  check_loaded(
      program, environment_of(program),
      [&path](Vocabulary& vocabulary) { vocabulary.may_be_alone = !lies_in_project(path); }, found);
}

}  // namespace jaywalk
