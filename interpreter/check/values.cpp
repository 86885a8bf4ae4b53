// SPDX-License-Identifier: Apache-2.0
// Atoms in arguments that are almost those that stand there otherwise: `move(rigth)`.

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/check/index/atom_flow.h"
#include "interpreter/check/index/traversal.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using AtomRole = AtomUse::Role;
using Atoms = std::set<std::string_view>;

/// How often each atom occurs in the program, as an argument or otherwise.
class AtomCounts {
 public:
  explicit AtomCounts(Checking& checking) {
    for (const CheckedFile& file : checking.files()) components(file.file->components);
  }

  [[nodiscard]] int of(std::string_view atom) const {
    const auto found = counts_.find(atom);
    return found == counts_.end() ? 0 : found->second;
  }

 private:
  void components(std::span<const ast::Component> components) {
    const auto count = [this](const Node& node) {
      if (node.kind == Kind::literal && node.args.empty()) ++counts_[node.text];
    };
    for (const ast::Component& component : components) {
      if (component.literal != nullptr) each_node(*component.literal, count);
      if (component.body != nullptr) each_node(*component.body, count);
      if (component.plan != nullptr) each_node(*component.plan, count);
      this->components(component.inner);
    }
  }

  std::unordered_map<std::string_view, int> counts_;
};

class Values {
 public:
  explicit Values(Checking& checking)
      : checking_(checking), occurrences_([&checking] { return AtomCounts(checking); }) {}

  void judge(const ValueClass& values) {
    const Atoms allowed = atoms_of(values, AtomRole::allowed);
    if (!allowed.empty()) judge_declared(values, allowed);
    judge_inferred(values, allowed);
    judge_strings(values, allowed);
  }

 private:
  static Atoms atoms_of(const ValueClass& values, AtomRole role) {
    Atoms atoms;
    for (const AtomUse& use : values.uses) {
      if (use.role == role && use.setting == nullptr) atoms.insert(use.atom);
    }
    return atoms;
  }

  static std::string_view slip_of(std::string_view atom, const Atoms& atoms) {
    const auto found =
        std::ranges::find_if(atoms, [&](auto each) { return is_one_slip(atom, each); });
    return found == atoms.end() ? std::string_view() : *found;
  }

  // The environment names the values: any other that reaches it is wrong if it resembles one, or if
  // it stands there itself, unless the program has beliefs of that name, too.
  void judge_declared(const ValueClass& values, const Atoms& allowed) {
    const Atoms wanted = atoms_of(values, AtomRole::wanted);
    const bool has_own = std::ranges::any_of(values.uses, [](const AtomUse& use) {
      return use.is_declared_here && use.role == AtomRole::given;
    });
    for (const AtomUse& use : values.uses) {
      if (use.role == AtomRole::allowed || allowed.contains(use.atom)) continue;
      const std::string_view meant = slip_of(use.atom, allowed);
      const bool none_of_them =
          use.setting != nullptr ? !wanted.contains(use.atom) : use.is_declared_here && !has_own;
      if (!meant.empty()) {
        warn(use, fmt::format("did you mean '{}'?", meant));
      } else if (none_of_them) {
        warn(use, fmt::format("the values are {}", fmt::join(allowed, ", ")));
      }
    }
  }

  // The program itself shows the possible values: a queried atom should be given somewhere.
  void judge_inferred(const ValueClass& values, const Atoms& allowed) {
    const bool asks = std::ranges::any_of(values.uses, [](const AtomUse& use) {
      return use.role == AtomRole::wanted || use.setting != nullptr;
    });
    if (!asks) return;
    Atoms given = atoms_of(values, AtomRole::given);
    given.insert(allowed.begin(), allowed.end());
    const Atoms wanted = atoms_of(values, AtomRole::wanted);
    std::map<std::string_view, int> uses_wanted;
    for (const AtomUse& use : values.uses) uses_wanted[use.atom] += use.role == AtomRole::wanted;
    for (const AtomUse& use : values.uses) {
      if (use.setting != nullptr) {
        if (allowed.empty()) judge_setting(use, given, wanted);
      } else if (use.role == AtomRole::wanted && !given.contains(use.atom) &&
                 occurrences_->of(use.atom) == uses_wanted[use.atom] &&
                 !checking_.vocabulary().named_by_others.contains(use.atom)) {
        judge_wanted(use, values, given);
      }
    }
  }

  void judge_wanted(const AtomUse& use, const ValueClass& values, const Atoms& given) {
    const auto meant = std::ranges::find_if(given, [&](std::string_view each) {
      return is_one_slip(use.atom, each) && is_misspelling(use.atom, each);
    });
    if (meant == given.end()) return;
    if (occurrences_->of(*meant) >= occurrences_->of(use.atom)) {
      warn(use, fmt::format("did you mean '{}'?", *meant));
      return;
    }
    // The rarer one is the slip, though it is what is given.
    for (const AtomUse& other : values.uses) {
      if (other.atom == *meant && other.role == AtomRole::given) {
        warn(other, fmt::format("did you mean '{}'?", use.atom));
      }
    }
  }

  void judge_setting(const AtomUse& use, const Atoms& given, const Atoms& wanted) {
    if (given.contains(use.atom) || wanted.contains(use.atom)) return;
    std::string_view meant = slip_of(use.atom, wanted);
    if (meant.empty()) meant = slip_of(use.atom, given);
    if (!meant.empty()) warn(use, fmt::format("did you mean '{}'?", meant));
  }

  // `move("right")`: a string is no atom, so that no value is equal to it.
  void judge_strings(const ValueClass& values, const Atoms& allowed) {
    Atoms atoms = atoms_of(values, AtomRole::given);
    atoms.insert(allowed.begin(), allowed.end());
    Atoms given;
    for (const AtomUse& use : values.strings) {
      if (use.role == AtomRole::given) given.insert(use.atom);
    }
    for (const AtomUse& use : values.strings) {
      const bool is_wanted = use.role == AtomRole::wanted;
      const bool is_found = is_wanted && given.contains(use.atom);
      std::string_view meant = atoms.contains(use.atom) ? use.atom : std::string_view();
      if (meant.empty()) meant = slip_of(use.atom, allowed);
      const bool is_wrong = allowed.empty() ? is_wanted && !meant.empty()
                                            : !meant.empty() || (is_wanted && use.is_declared_here);
      if (!is_wrong || is_found) continue;
      checking_.warn(*use.file, use.span,
                     fmt::format("\"{}\" is a string, and the values here are atoms", use.atom),
                     meant.empty() ? fmt::format("the values are {}", fmt::join(allowed, ", "))
                                   : fmt::format("write {}, without quotes", meant));
    }
  }

  void warn(const AtomUse& use, std::string hint) {
    std::string message = fmt::format("'{}' is none of the values that occur here", use.atom);
    if (use.setting != nullptr) {
      checking_.warn(*use.setting, std::move(message), std::move(hint));
    } else {
      checking_.warn(*use.file, use.span, std::move(message), std::move(hint));
    }
  }

  Checking& checking_;
  Lazy<AtomCounts> occurrences_;
};

}  // namespace

void unknown_values(Checking& checking) {
  Values values(checking);
  for (const ValueClass& each : value_classes(checking)) values.judge(each);
}

}  // namespace jaywalk
