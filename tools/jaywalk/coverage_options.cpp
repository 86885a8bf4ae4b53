#include "tools/jaywalk/coverage_options.h"

#include <set>

#include <fmt/format.h>

#include "tools/jaywalk/output_files.h"

namespace jaywalk {
namespace {

std::string render(const std::string& path, const SourceCoverage& coverage) {
  if (path.ends_with(".html")) return coverage_html(coverage, "Coverage of agents' programs");
  if (path.ends_with(".info")) return coverage_lcov(coverage);
  return coverage_text(coverage);
}

}  // namespace

void check_coverage_options(const Arguments& arguments, Diagnostics& diagnostics) {
  for (const std::string& path : arguments.texts("coverage")) {
    if (path.ends_with(".html") || path.ends_with(".info") || path.ends_with(".txt")) continue;
    diagnostics.error("--coverage",
                      fmt::format("expected a file .txt, .html or .info, found '{}'", path));
  }
}

bool write_coverage(const Arguments& arguments, const SourceCoverage& coverage, Console& console) {
  bool written = true;
  for (const std::string& path : arguments.texts("coverage")) {
    written = write_output(path, render(path, coverage), console) && written;
  }
  return written;
}

SourceCoverage locate_in_files(const Probes& probes, const CoverageCounts& counts) {
  std::set<std::string> names;
  for (const ProbedPlan& plan : probes.plans()) names.insert(plan.plan->file);
  for (const ProbedRule& rule : probes.rules()) {
    if (rule.where.source != nullptr) names.insert(rule.where.source->name());
  }
  std::vector<SourcePtr> sources;
  for (const std::string& name : names) {
    auto source = read_source(name);
    if (source.ok()) sources.push_back(std::move(source).value());
  }
  return locate(probes, counts, find_texts(probes, sources));
}

}  // namespace jaywalk
