// SPDX-License-Identifier: Apache-2.0
#pragma once

// One agent's percepts, look by look. An environment reports all of them in every look, but most
// are unchanged. So each report is compared, literal by literal and in order, with that of the
// last look, two words for each argument:
//
//   last look:   tick(1)  at(2,5)  av(3)  grid(10,60)
//   this look:   tick(2)  at(2,6)  av(3)  grid(10,60)       news: 0, 1    gone: tick(1), at(2,5)
//
// From the first predicate that differs, the rest of the last look is gone and the rest of this one
// is news, less the end that both have in common. So an environment does best to report things in
// the same order every time, those that come and go last.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "interpreter/term/value.h"

namespace jaywalk {

/// One agent's percepts in one look: ground literals. Written by the environment, read by belief
/// update. Arguments other than numbers and atoms, and annotations, are the environment's.
class Percepts {
 public:
  /// REQUIRES: as many arguments as the predicate has.
  void add(Predicate predicate, std::initializer_list<Value> args) {
    add(predicate, std::span<const Value>(args.begin(), args.size()));
  }
  void add(Predicate predicate, std::span<const Value> args) {
    if (next_ < told_before_ && entries_[next_].predicate == predicate) {
      const Value* const known = args_.data() + next_arg_;
      for (std::size_t i = 0; i < args.size(); ++i) {
        if (known[i].same_as(args[i])) continue;
        change(args, Value::empty_list());
        break;
      }
      ++next_;
      next_arg_ += args.size();
      return;
    }
    add_behind(predicate, args, Value::empty_list());
  }
  /// Any ground terms, which must outlive the next look.
  void add(Predicate predicate, std::span<const Value> args, Value annotations);
  /// Instead of reporting the rest: it is as in the last look from the literal of `first`
  /// on, under the same number, which the environment gives anew when the rest changes. False: that
  /// was not so, and it has to be reported.
  [[nodiscard]] bool keep_rest(Predicate first, std::uint64_t number) {
    if (next_ < told_before_ && entries_[next_].predicate == first && rest_number_ == number) {
      next_ = told_before_;
      next_arg_ = args_.size();
      return true;
    }
    rest_number_ = number;
    return false;
  }
  /// Forgets everything, the last look too.
  void clear();

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] Predicate predicate(std::size_t index) const { return entries_[index].predicate; }
  [[nodiscard]] std::span<const Value> args(std::size_t index) const {
    return args(entries_, args_, index);
  }
  [[nodiscard]] Value annotations(std::size_t index) const { return entries_[index].annotations; }

  // Looks. Between begin_look and end_look the environment reports everything.
  void begin_look();
  void end_look();
  /// How many looks there have been.
  [[nodiscard]] std::uint64_t looks() const { return looks_; }
  /// The literals that the last look did not report, in order, as indices; a literal that only
  /// changed its place may be among them.
  [[nodiscard]] std::span<const std::uint32_t> news() const { return news_; }
  /// How many of the first news stand where the first of the gone literals stood, with the same
  /// predicates.
  [[nodiscard]] std::size_t changed_size() const { return changed_; }
  /// The number of literals of the last look that this one reports no more.
  [[nodiscard]] std::size_t gone_size() const { return gone_.size(); }
  [[nodiscard]] Predicate gone_predicate(std::size_t index) const { return gone_[index].predicate; }
  [[nodiscard]] std::span<const Value> gone_args(std::size_t index) const {
    return args(gone_, gone_args_, index);
  }

 private:
  struct Entry {
    Predicate predicate{};
    std::uint32_t end = 0;  // of its arguments
    Value annotations = Value::empty_list();
  };
  static std::span<const Value> args(const std::vector<Entry>& entries,
                                     const std::vector<Value>& args, std::size_t index) {
    const std::size_t begin = index == 0 ? 0 : entries[index - 1].end;
    return std::span(args).subspan(begin, entries[index].end - begin);
  }

  void change(std::span<const Value> args, Value annotations);
  void add_behind(Predicate predicate, std::span<const Value> args, Value annotations);
  void drop_rest();
  void keep_common_end();
  void add_gone(Predicate predicate, std::span<const Value> args);

  std::vector<Entry> entries_;
  std::vector<Value> args_;
  std::vector<std::uint32_t> news_;
  std::vector<Entry> gone_;
  std::vector<Value> gone_args_;
  std::uint64_t looks_ = 0;
  // Within a look: the first entries are of the last one, and those before the next have been
  // reported.
  std::size_t told_before_ = 0;
  std::size_t next_ = 0;
  std::size_t next_arg_ = 0;
  std::size_t changed_ = 0;
  std::uint64_t rest_number_ = 0;
  // News and gone ones before the rest was dropped.
  std::size_t news_before_ = 0;
  std::size_t gone_before_ = 0;
};

}  // namespace jaywalk
