// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/load.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/parser.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

// In any encoding. What cannot be read for another reason says so.
Result<SourcePtr> read_program(const std::string& path, const SourceFiles& files,
                               Diagnostics& diagnostics) {
  Result<SourcePtr> source = files.read(path);
  return source || !files.has(path) ? source : read_any_encoding(files.place(path), diagnostics);
}

// A text that is given for the file at a path; null if there is none.
const std::string* text_at(const std::string& path, const IncludePath& include_path) {
  const auto found = std::ranges::find_if(include_path.given, [&](const auto& each) {
    return each.first == path && path.find('/') != std::string::npos;
  });
  return found == include_path.given.end() ? nullptr : &found->second;
}

class Loader {
 public:
  Loader(const IncludePath& include_path, Diagnostics& diagnostics)
      : include_path_(include_path), diagnostics_(diagnostics) {}

  SourceTree load(SourcePtr source) {
    add_file(std::make_unique<ast::File>(parse_agent(std::move(source), diagnostics_)));
    return std::move(tree_);
  }

 private:
  const ast::File* add_file(std::unique_ptr<ast::File> parsed) {
    chain_.push_back(parsed->source->name());
    // Included files come behind the including one, whose place is thereby its own.
    tree_.files.push_back(std::move(parsed));
    const ast::File* const file = tree_.files.back().get();
    follow(file->components, *file);
    chain_.pop_back();
    return file;
  }

  // A file with errors is left out, with all that it includes.
  void add_included(const ast::Component& directive, SourcePtr source) {
    const bool is_program = source->name() == include_path_.program;
    Diagnostics found;
    auto parsed = std::make_unique<ast::File>(parse_agent(std::move(source), found));
    const std::size_t errors = found.error_count();
    diagnostics_.append(std::move(found));
    if (errors == 0 || is_program) {
      tree_.includes[&directive] = add_file(std::move(parsed));
    } else {
      tree_.left_out_errors += errors;
    }
  }

  void follow(std::span<const ast::Component> components, const ast::File& file) {
    for (const ast::Component& component : components) {
      if (component.kind != ast::ComponentKind::directive) continue;
      if (component.is_block) {
        follow(component.inner, file);
      } else if (component.literal->text == "include") {
        include(component, file);
      }
    }
  }

  void include(const ast::Component& directive, const ast::File& file) {
    const std::span<const ast::Node* const> args = directive.literal->args;
    if (args.empty() || args.front()->kind != ast::Kind::string) {
      diagnostics_.error({file.source, directive.literal->span},
                         "include needs the name of a file, a string",
                         "as in { include(\"common.asl\") }");
      return;
    }
    const std::string name(args.front()->text);
    if (const std::string* const text = include_path_.given_text(name)) {
      add_included(directive, std::make_shared<const Source>(name, *text));
      return;
    }
    const SourceSpan where = {file.source, args.front()->span};
    const std::optional<std::string> path = find(name, where);
    if (!path || !may_include(*path, where)) return;
    if (const std::string* const text = text_at(*path, include_path_)) {
      add_included(directive, std::make_shared<const Source>(*path, *text));
      return;
    }
    if (!may_read(*path, where)) return;
    Result<SourcePtr> source = read_program(*path, include_path_.files, diagnostics_);
    if (!source) {
      diagnostics_.error(where, fmt::format("cannot include {}: {}", *path,
                                            source.diagnostics().items().front().message));
      ++tree_.left_out_errors;
      return;
    }
    add_included(directive, source.value());
  }

  [[nodiscard]] bool is_file(const fs::path& path) const {
    const std::string name = path.generic_string();
    return text_at(name, include_path_) != nullptr || include_path_.files.has(name);
  }

  bool may_read(const std::string& path, const SourceSpan& where) {
    if (!include_path_.files.are_on_disk()) return true;
    if (!readable_) {
      const fs::path program(tree_.main().source->name());
      readable_ = include_path_.readable_from(program.parent_path().string());
    }
    const auto denial = readable_->denial(include_path_.files.place(path));
    if (!denial) return true;
    diagnostics_.error(where, fmt::format("cannot include {}: {}", path, denial->message),
                       denial->hint);
    ++tree_.left_out_errors;
    return false;
  }

  bool may_include(const std::string& path, const SourceSpan& where) {
    if (std::find(chain_.begin(), chain_.end(), path) != chain_.end()) {
      diagnostics_.error(where, fmt::format("{} includes itself", path));
      return false;
    }
    if (chain_.size() > kMaxIncludeDepth) {
      diagnostics_.error(where,
                         fmt::format("includes are nested deeper than {}", kMaxIncludeDepth));
      return false;
    }
    if (tree_.files.size() > kMaxIncludedFiles) {
      if (!std::exchange(too_many_, true)) {
        diagnostics_.error(where, fmt::format("more than {} included files", kMaxIncludedFiles));
      }
      return false;
    }
    return true;
  }

  void warn(const SourceSpan& where, std::string message, std::string hint) {
    diagnostics_.warning(where, std::string(kMissingInclude), std::move(message), std::move(hint));
  }

  // The file that a name in an include directive means, or nothing but a warning, as in Jason.
  std::optional<std::string> find(const std::string& name, const SourceSpan& where) {
    if (name.find("://") != std::string::npos || name.starts_with("jar:")) {
      warn(where, fmt::format("cannot include '{}'", name), "only files can be included");
      return std::nullopt;
    }
    if (name.starts_with('$')) return find_mapped(name, where);
    // As in Jason a path from the folder in which the program is run is kept as it is written.
    const fs::path folder = fs::path(where.source->name()).parent_path();
    std::vector<fs::path> candidates = {folder.empty() ? fs::path(name)
                                                       : (folder / name).lexically_normal()};
    for (const auto* folders : {&include_path_.source_path, &include_path_.folders}) {
      for (const std::string& searched : *folders) {
        candidates.push_back((fs::path(searched) / name).lexically_normal());
      }
    }
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [this](const fs::path& path) { return is_file(path); });
    if (found != candidates.end()) return found->generic_string();
    if (auto installed = find_installed(name, where)) return installed;
    if (const std::string named = "$" + name; named.starts_with(kLibraryPrefix) && is_file(named)) {
      warn(where, fmt::format("cannot find '{}', which is included here", name),
           fmt::format("did you mean '{}'?", named));
      return std::nullopt;
    }
    std::string places = fmt::format("looked for {}", candidates.front().generic_string());
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      places += fmt::format(", {}", candidates[i].generic_string());
    }
    warn(where, fmt::format("cannot find '{}', which is included here", name), std::move(places));
    return std::nullopt;
  }

  // A program that was copied from the installed ones finds its included files there.
  std::optional<std::string> find_installed(const std::string& name, const SourceSpan& where) {
    if (name.find('/') == std::string::npos) return std::nullopt;
    std::string_view below = name;  // of a world's folder, from whatever folder in it
    while (below.starts_with("../")) below.remove_prefix(3);
    auto installed = include_path_.files.find_installed(below);
    if (!installed) return std::nullopt;
    diagnostics_.add({.severity = Severity::note,
                      .message = fmt::format("'{}' is not beside the program; the installed one "
                                             "is taken",
                                             name),
                      .where = where,
                      .hint = fmt::format("include(\"{}\") says so", *installed),
                      .code = {},
                      .subject = {}});
    return installed;
  }

  // `$jaywalk/crossing/shared/steps.asl`: installed with Jaywalk.
  std::optional<std::string> find_in_library(const std::string& name, const SourceSpan& where) {
    const std::string path = fs::path(name).lexically_normal().generic_string();
    if (is_file(path)) return path;
    const std::string folder = fs::path(path).parent_path().generic_string();
    const std::vector<std::string> known = include_path_.files.installed_in(folder);
    std::string hint = did_you_mean(path, known);
    if (hint.empty()) {
      hint = known.empty() ? "the programs of the crossing are in $jaywalk/crossing"
                           : fmt::format("in that folder are {}", fmt::join(known, ", "));
    }
    warn(where, fmt::format("cannot find '{}', which is included here", name), std::move(hint));
    return std::nullopt;
  }

  // `$jasonJar/asl/x.asl`, by the prefixes that the user has given a folder.
  std::optional<std::string> find_mapped(const std::string& name, const SourceSpan& where) {
    const std::string prefix = name.substr(0, name.find('/'));
    for (const auto& [mapped, folder] : include_path_.mapped) {
      if (mapped != prefix) continue;
      const fs::path path =
          (fs::path(folder) / name.substr(std::min(name.size(), prefix.size() + 1)))
              .lexically_normal();
      if (is_file(path)) return path.generic_string();
      warn(where, fmt::format("cannot find '{}', which is included here", name),
           fmt::format("looked for {}", path.generic_string()));
      return std::nullopt;
    }
    if (name.starts_with(kLibraryPrefix)) return find_in_library(name, where);
    warn(where, fmt::format("unknown folder '{}' in this include", prefix),
         fmt::format("say where it is with --map '{}=FOLDER'", prefix));
    return std::nullopt;
  }

  const IncludePath& include_path_;
  Diagnostics& diagnostics_;
  SourceTree tree_;
  /// The files that include one another, from the program to the one that is being read.
  std::vector<std::string> chain_;
  bool too_many_ = false;
  std::optional<AllowedFolders> readable_;  // once asked for
};

}  // namespace

AllowedFolders IncludePath::readable_from(const std::string& folder) const {
  AllowedFolders readable = files.readable_from(folder);
  for (const std::string& each : folders) readable.add(each);
  for (const auto& [prefix, meant] : mapped) readable.add(meant);
  return readable;
}

const std::string* IncludePath::given_text(std::string_view path) const {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const auto found = std::find_if(given.begin(), given.end(),
                                  [&](const auto& each) { return each.first == name; });
  return found == given.end() ? nullptr : &found->second;
}

SourceTree load_agent(const std::string& path, const IncludePath& include_path,
                      Diagnostics& diagnostics) {
  if (const std::string* const text = text_at(path, include_path)) {
    return load_agent(std::make_shared<const Source>(path, *text), include_path, diagnostics);
  }
  Result<SourcePtr> source = read_program(path, include_path.files, diagnostics);
  if (source) return load_agent(source.value(), include_path, diagnostics);
  diagnostics.append(std::move(source.diagnostics()));
  return load_agent(std::make_shared<const Source>(path, ""), include_path, diagnostics);
}

SourceTree load_agent(SourcePtr source, const IncludePath& include_path, Diagnostics& diagnostics) {
  return Loader(include_path, diagnostics).load(std::move(source));
}

}  // namespace jaywalk
