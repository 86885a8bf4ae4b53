#include "interpreter/check/bindings.h"

#include "interpreter/check/index/traversal.h"
#include "interpreter/support/characters.h"

namespace jaywalk {
namespace {

// `_12abc` is the variable `_12`; every other `_x` is a variable of its own, wherever it stands.
std::string_view identity(std::string_view name) {
  if (name.front() != '_') return name;
  std::size_t end = 1;
  while (end < name.size() && is_digit(name[end])) ++end;
  return end == 1 ? std::string_view() : name.substr(0, end);
}

}  // namespace

bool MaybeBound::contains(const ast::Node& variable) const {
  const std::string_view name = identity(variable.text);
  return !name.empty() && (everything_ || bound_.contains(name));
}

void MaybeBound::add_all_in(const ast::Node& term) {
  each_node(term, [this](const ast::Node& node) {
    if (node.kind == ast::Kind::variable) add(identity(node.text));
  });
}

void MaybeBound::add(std::string_view name) {
  if (!name.empty() && bound_.insert(name).second) trail_.push_back(name);
}

void MaybeBound::add(const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) add(name);
}

std::vector<std::string_view> MaybeBound::undo(Mark mark) {
  std::vector<std::string_view> undone(trail_.begin() + static_cast<std::ptrdiff_t>(mark),
                                       trail_.end());
  for (const std::string_view name : undone) bound_.erase(name);
  trail_.resize(mark);
  return undone;
}

void MaybeBound::lose(Mark mark, std::string_view why) {
  for (const std::string_view name : undo(mark)) lost_[name] = why;
}

std::string_view MaybeBound::why_lost(std::string_view name) const {
  const auto found = lost_.find(identity(name));
  return found == lost_.end() ? std::string_view() : found->second;
}

}  // namespace jaywalk
