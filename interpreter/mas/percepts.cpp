#include "interpreter/mas/environment.h"

namespace jaywalk {

void Percepts::add(Predicate predicate, std::span<const Value> args) {
  predicates_.push_back(predicate);
  args_.insert(args_.end(), args.begin(), args.end());
  ends_.push_back(args_.size());
}

void Percepts::clear() {
  predicates_.clear();
  ends_.clear();
  args_.clear();
}

std::span<const Value> Percepts::args(std::size_t index) const {
  const std::size_t begin = index == 0 ? 0 : ends_[index - 1];
  return std::span(args_).subspan(begin, ends_[index] - begin);
}

}  // namespace jaywalk
