// SPDX-License-Identifier: Apache-2.0
#include "interpreter/environment/percepts.h"

#include <algorithm>
#include <cstdint>

#include "interpreter/term/compare.h"
#include <jaywalk/environment.h>

namespace jaywalk {

void Percepts::clear() {
  entries_.clear();
  args_.clear();
  looks_ = 0;
  rest_number_ = 0;
  begin_look();
  looks_ = 0;
}

void Percepts::begin_look() {
  ++looks_;
  news_.clear();
  gone_.clear();
  gone_args_.clear();
  told_before_ = entries_.size();
  next_ = 0;
  next_arg_ = 0;
  changed_ = 0;
  news_before_ = gone_before_ = SIZE_MAX;  // the rest has not been dropped
}

void Percepts::end_look() {
  if (next_ < told_before_) drop_rest();
  keep_common_end();
  told_before_ = 0;
}

// Terms in memory of the environment are those of the latest look, whose literals live longest.
void Percepts::add(Predicate predicate, std::span<const Value> args, Value annotations) {
  if (next_ >= told_before_ || entries_[next_].predicate != predicate) {
    add_behind(predicate, args, annotations);
    return;
  }
  const auto known = args_.begin() + static_cast<std::ptrdiff_t>(next_arg_);
  if (std::equal(args.begin(), args.end(), known,
                 [](Value a, Value b) { return equal_terms(a, b); })) {
    std::copy(args.begin(), args.end(), known);
    entries_[next_].annotations = annotations;
  } else {
    change(args, annotations);
  }
  ++next_;
  next_arg_ += args.size();
}

// The next one is of the same predicate, but with other arguments.
void Percepts::change(std::span<const Value> args, Value annotations) {
  const auto known = args_.begin() + static_cast<std::ptrdiff_t>(next_arg_);
  add_gone(entries_[next_].predicate, std::span(args_).subspan(next_arg_, args.size()));
  std::copy(args.begin(), args.end(), known);
  entries_[next_].annotations = annotations;
  news_.push_back(static_cast<std::uint32_t>(next_));
  ++changed_;
}

void Percepts::add_behind(Predicate predicate, std::span<const Value> args, Value annotations) {
  if (next_ < told_before_) drop_rest();
  args_.insert(args_.end(), args.begin(), args.end());
  news_.push_back(static_cast<std::uint32_t>(entries_.size()));
  entries_.push_back({predicate, static_cast<std::uint32_t>(args_.size()), annotations});
}

// The rest of the last look has to be reported anew.
void Percepts::drop_rest() {
  news_before_ = news_.size();
  gone_before_ = gone_.size();
  for (std::size_t i = next_; i < told_before_; ++i) add_gone(predicate(i), args(i));
  entries_.resize(next_);
  args_.resize(next_arg_);
  told_before_ = next_;
}

void Percepts::keep_common_end() {
  while (news_.size() > news_before_ && gone_.size() > gone_before_) {
    const std::size_t newest = news_.back();
    const std::size_t last = gone_.size() - 1;
    const bool is_common = predicate(newest) == gone_predicate(last) &&
                           std::ranges::equal(args(newest), gone_args(last),
                                              [](Value a, Value b) { return a.same_as(b); });
    if (!is_common) return;
    news_.pop_back();
    gone_args_.resize(gone_args_.size() - args(newest).size());
    gone_.pop_back();
  }
}

void Percepts::add_gone(Predicate predicate, std::span<const Value> args) {
  gone_args_.insert(gone_args_.end(), args.begin(), args.end());
  gone_.push_back({predicate, static_cast<std::uint32_t>(gone_args_.size()), Value::empty_list()});
}

void add_percept(Percepts& percepts, Predicate predicate, std::initializer_list<Value> args) {
  percepts.add(predicate, args);
}
void add_percept(Percepts& percepts, Predicate predicate, std::span<const Value> args) {
  percepts.add(predicate, args);
}
void add_percept(Percepts& percepts, const GroundLiteral& literal) {
  percepts.add(literal.predicate(), literal.args(), literal.annotations());
}

}  // namespace jaywalk
