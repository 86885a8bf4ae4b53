#pragma once

// Which variables may have a value at a point of a plan or rule. Entries can be undone to a mark,
// for branches and loops.

#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "interpreter/syntax/ast.h"

namespace jaywalk {

class MaybeBound {
 public:
  using Mark = std::size_t;

  [[nodiscard]] bool contains(const ast::Node& variable) const;
  /// All variables of the term may have a value from here on.
  void add_all_in(const ast::Node& term);
  void add(std::string_view name);
  void add(const std::vector<std::string_view>& names);
  /// From here on every variable may have a value, because an unknown body was carried out.
  void add_everything() { everything_ = true; }

  [[nodiscard]] Mark mark() const { return trail_.size(); }
  /// Removes the variables that were added since the mark, and returns them.
  std::vector<std::string_view> undo(Mark mark);
  /// Like undo(), and remembers why for the hint.
  void lose(Mark mark, std::string_view why);
  /// Why the variable has no value any more; empty if it never had one.
  [[nodiscard]] std::string_view why_lost(std::string_view name) const;

 private:
  std::set<std::string_view> bound_;
  std::vector<std::string_view> trail_;
  std::map<std::string_view, std::string_view> lost_;
  bool everything_ = false;
};

}  // namespace jaywalk
