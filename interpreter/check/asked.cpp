// SPDX-License-Identifier: Apache-2.0
// Names that an included file asks for (`// jaywalk: asks NAME/ARITY`) and the program does not
// define.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/support/remarks.h"

namespace jaywalk {
namespace {

using ast::Component;
using ast::Node;

/// A head of a belief, rule or plan.
struct Definition {
  CheckedFile* file = nullptr;
  const Node* head = nullptr;
};

class Asked {
 public:
  explicit Asked(Checking& checking)
      : checking_(checking),
        beliefs_([this] { return definitions(Kind::belief); }),
        goals_([this] { return definitions(Kind::goal); }) {}

  void look_at(const CheckedFile& library, std::string_view item) {
    const AskedName asked = *asked_name(item);
    CheckedFile& main = checking_.files().front();
    if (is_defined(asked) || main.asked.contains(item)) return;
    // Several files may ask for the same.
    if (!told_.insert(item).second) return;
    std::string needed = fmt::format("'{}' asks for '{}'", file_name(library), name_of(asked));
    if (checking_.is_full(main)) {
      return warn({&main, include_of(*library.file)}, needed, "");
    }
    const std::vector<Definition>& known = asked.is_goal ? *goals_ : *beliefs_;
    if (const auto other = named(asked.name, library, known)) {
      needed += fmt::format(" with {}", counted(std::set{asked.arity}));
      return warn(*other, needed,
                  fmt::format("here it has {}", counted(std::set{arity_of(*other->head)})));
    }
    if (const auto misspelt = misspelt_for(asked.name, library, known)) {
      return warn(*misspelt, needed, fmt::format("did you mean '{}'?", asked.name));
    }
    std::string hint = checking_.library_defining(item);
    if (hint.empty()) hint = example(asked);
    warn({&main, include_of(*library.file)}, needed, std::move(hint));
  }

 private:
  enum class Kind : std::uint8_t { belief, goal };

  [[nodiscard]] bool is_defined(const AskedName& asked) const {
    const ProgramIndex& index = checking_.index();
    if (index.has_unread_parts || checking_.vocabulary().named_by_others.contains(asked.name)) {
      return true;
    }
    return asked.is_goal ? checking_.may_be_told_plans() ||
                               index.planned_goals.contains(asked.name, asked.arity)
                         : checking_.answers().contains(asked.name, asked.arity);
  }

  /// The first definition of each name in each file.
  [[nodiscard]] std::vector<Definition> definitions(Kind kind) const {
    std::vector<Definition> all;
    for (CheckedFile& file : checking_.files()) {
      std::set<std::string_view> known;
      const auto add = [&](const Node& head) {
        if (known.insert(head.text).second) all.push_back({&file, &head});
      };
      if (kind == Kind::belief) {
        for (const Clause& clause : file.uses.clauses) add(*clause.head);
        continue;
      }
      for (const ast::Plan* plan : file.uses.plans) {
        if (is_for_goal(*plan)) add(*plan->trigger.literal);
      }
    }
    return all;
  }

  /// A definition of that name outside the file that asks for it.
  static std::optional<Definition> named(std::string_view name, const CheckedFile& library,
                                         const std::vector<Definition>& known) {
    const auto found = std::ranges::find_if(known, [&](const Definition& each) {
      return each.file != &library && each.head->text == name;
    });
    return found == known.end() ? std::nullopt : std::optional(*found);
  }

  /// The definition that nothing uses and whose name is almost the one that is asked for.
  [[nodiscard]] std::optional<Definition> misspelt_for(std::string_view name,
                                                       const CheckedFile& library,
                                                       const std::vector<Definition>& known) const {
    std::vector<std::string> unused;
    for (const Definition& each : known) {
      if (each.file != &library && !checking_.is_mentioned(each.head->text)) {
        unused.emplace_back(each.head->text);
      }
    }
    const auto meant = closest(name, unused);
    return meant ? named(*meant, library, known) : std::nullopt;
  }

  /// The name of the file in the program's own include that leads to it.
  [[nodiscard]] const Node* include_of(const ast::File& wanted) const {
    return include_of(checking_.program().main().components, wanted);
  }

  [[nodiscard]] const Node* include_of(std::span<const Component> components,
                                       const ast::File& wanted) const {
    for (const Component& component : components) {
      if (const Node* const found = include_of(component.inner, wanted)) return found;
      const auto included = checking_.program().includes.find(&component);
      if (included == checking_.program().includes.end()) continue;
      const bool leads_there = included->second == &wanted ||
                               include_of(included->second->components, wanted) != nullptr;
      if (leads_there) return component.literal->args.front();
    }
    return nullptr;
  }

  void warn(const Definition& where, std::string_view needed, std::string hint) {
    checking_.warn(*where.file, where.head->span,
                   fmt::format("{}, which this program does not define", needed), std::move(hint));
  }

  static std::string name_of(const AskedName& asked) {
    return fmt::format("{}{}", asked.is_goal ? "!" : "", asked.name);
  }

  static std::string_view file_name(const CheckedFile& file) {
    const std::string_view path = file.file->source->name();
    return path.substr(path.rfind('/') + 1);
  }

  static std::string example(const AskedName& asked) {
    std::string arguments;
    for (int i = 0; i < asked.arity; ++i) arguments += i == 0 ? "(_" : ",_";
    if (asked.arity > 0) arguments += ')';
    return asked.is_goal ? fmt::format("add a plan: +!{}{} <- ...", asked.name, arguments)
                         : fmt::format("add a rule: {}{} :- ...", asked.name, arguments);
  }

  Checking& checking_;
  Lazy<std::vector<Definition>> beliefs_;
  Lazy<std::vector<Definition>> goals_;
  std::set<std::string_view> told_;
};

}  // namespace

void missing_definitions(Checking& checking) {
  Asked asked(checking);
  for (const CheckedFile& file : checking.files()) {
    if (file.is_main) continue;
    for (const std::string_view item : file.asked) asked.look_at(file, item);
  }
}

}  // namespace jaywalk
