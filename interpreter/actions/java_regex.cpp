#include "interpreter/actions/java_regex.h"

#include <algorithm>
#include <utility>

#include "interpreter/actions/java_text.h"

namespace jaywalk::actions {
namespace {

constexpr std::size_t kMaxProgram = 20'000;
constexpr std::uint32_t kMaxRepeat = 1000;
constexpr int kMaxDepth = 200;

bool is_word(char32_t c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= 'a' && c <= 'z');
}

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }

bool is_line_end(char32_t c) {
  return c == '\n' || c == '\r' || c == 0x85 || c == 0x2028 || c == 0x2029;
}

}  // namespace

// Recursive descent; each construct becomes a piece of program, which repetition copies.
class RegexParser {
 public:
  RegexParser(std::string_view pattern, Regex& regex) : pattern_(pattern), regex_(regex) {}

  bool parse(std::string& error) {
    Piece piece = alternatives();
    if (error_.empty() && at_ < pattern_.size()) fail("unmatched ')'");
    if (!error_.empty()) {
      error = error_ + " near index " + std::to_string(at_);
      return false;
    }
    regex_.program_.push_back({Kind::save, 0});
    append(regex_.program_, piece);
    regex_.program_.push_back({Kind::save, 1});
    regex_.program_.push_back({Kind::match});
    return true;
  }

 private:
  using Kind = Regex::Instruction::Kind;
  // Targets of jumps count from the piece's own beginning.
  using Piece = std::vector<Regex::Instruction>;

  void fail(std::string_view why) {
    if (error_.empty()) error_ = why;
    at_ = pattern_.size();
  }
  [[nodiscard]] bool more() const { return at_ < pattern_.size(); }
  [[nodiscard]] bool next_is(char c) const { return more() && pattern_[at_] == c; }
  bool take(char c) {
    if (!next_is(c)) return false;
    ++at_;
    return true;
  }
  bool take(std::string_view text) {
    if (pattern_.substr(at_).substr(0, text.size()) != text) return false;
    at_ += text.size();
    return true;
  }
  char32_t character() {
    std::size_t size = 0;
    const char32_t c = character_at(pattern_, at_, size);
    at_ += size;
    return c;
  }

  void append(Piece& to, const Piece& piece) {
    if (to.size() + piece.size() > kMaxProgram) {
      fail("the pattern is too large");
      return;
    }
    const auto offset = static_cast<std::uint32_t>(to.size());
    for (Regex::Instruction instruction : piece) {
      if (instruction.kind == Kind::split || instruction.kind == Kind::jump) {
        instruction.x += offset;
        instruction.y += offset;
      }
      to.push_back(instruction);
    }
  }

  Piece alternatives() {
    if (++depth_ > kMaxDepth) fail("groups are nested too deeply");
    Piece left = sequence();
    while (take('|')) {
      const Piece right = sequence();
      Piece both{{Kind::split, 1, static_cast<std::uint32_t>(left.size()) + 2}};
      append(both, left);
      const auto end = static_cast<std::uint32_t>(left.size() + right.size()) + 2;
      both.push_back({Kind::jump, end});
      append(both, right);
      left = std::move(both);
    }
    --depth_;
    return left;
  }

  Piece sequence() {
    Piece all;
    while (more() && !next_is('|') && !next_is(')')) append(all, repeated());
    return all;
  }

  Piece repeated() {
    Piece piece = atom();
    while (more()) {
      std::uint32_t least = 0;
      std::uint32_t most = kMaxRepeat + 1;  // no limit
      if (take('*')) {
      } else if (take('+')) {
        least = 1;
      } else if (take('?')) {
        most = 1;
      } else if (next_is('{')) {
        ++at_;
        if (!bounds(least, most)) return piece;
      } else {
        break;
      }
      const bool lazy = take('?');
      if (!lazy) (void)take('+');  // possessive: as greedy
      piece = repeat(piece, least, most, lazy);
    }
    return piece;
  }

  bool bounds(std::uint32_t& least, std::uint32_t& most) {
    const auto number = [this](std::uint32_t& value) {
      value = 0;
      bool any = false;
      while (more() && is_digit(static_cast<unsigned char>(pattern_[at_]))) {
        value = value * 10 + static_cast<std::uint32_t>(pattern_[at_++] - '0');
        any = true;
        if (value > kMaxRepeat) {
          fail("a repetition is larger than 1000");
          return false;
        }
      }
      return any;
    };
    if (!number(least)) {
      fail("illegal repetition");
      return false;
    }
    if (!take(',')) {
      most = least;
    } else if (!next_is('}') && (!number(most) || most < least)) {
      fail("illegal repetition range");
      return false;
    }
    if (!take('}')) {
      fail("unclosed counted closure");
      return false;
    }
    return true;
  }

  Piece repeat(const Piece& piece, std::uint32_t least, std::uint32_t most, bool lazy) {
    Piece all;
    for (std::uint32_t i = 0; i < least && error_.empty(); ++i) append(all, piece);
    const auto size = static_cast<std::uint32_t>(piece.size());
    const auto split = [lazy](std::uint32_t in, std::uint32_t out) {
      return lazy ? Regex::Instruction{Kind::split, out, in}
                  : Regex::Instruction{Kind::split, in, out};
    };
    if (most > kMaxRepeat) {
      Piece loop{split(1, size + 2)};
      append(loop, piece);
      loop.push_back({Kind::jump, 0});
      append(all, loop);
      return all;
    }
    for (std::uint32_t i = least; i < most && error_.empty(); ++i) {
      Piece once{split(1, size + 1)};
      append(once, piece);
      append(all, once);
    }
    return all;
  }

  Piece atom() {
    if (take('(')) return group();
    if (take('[')) return one_of(bracket());
    if (take('.')) return {{Kind::any}};
    if (take('^')) return {{Kind::line_begin}};
    if (take('$')) return {{Kind::line_end}};
    if (next_is('*') || next_is('+') || next_is('?')) {
      fail("dangling meta character");
      return {};
    }
    if (take('\\')) return escape();
    return literal(character());
  }

  Piece group() {
    bool captures = true;
    const bool outer_fold = fold_case_;
    if (take("?:")) {
      captures = false;
    } else if (take("?i)")) {
      fold_case_ = true;
      return {};
    } else if (take("?i:")) {
      captures = false;
      fold_case_ = true;
    } else if (next_is('?')) {
      fail("this kind of group is not supported");
      return {};
    }
    const auto slot = static_cast<std::uint32_t>(2 * regex_.groups_);
    if (captures) ++regex_.groups_;
    const Piece inner = alternatives();
    fold_case_ = outer_fold;
    if (!take(')')) {
      fail("unclosed group");
      return {};
    }
    if (!captures) return inner;
    Piece all{{Kind::save, slot}};
    append(all, inner);
    all.push_back({Kind::save, slot + 1});
    return all;
  }

  Piece one_of(Regex::CharacterClass set) {
    set.fold_case = fold_case_;
    regex_.classes_.push_back(std::move(set));
    return {{Kind::one_of, static_cast<std::uint32_t>(regex_.classes_.size() - 1)}};
  }
  Piece literal(char32_t c) { return one_of({{{c, c}}, false, false}); }

  Piece escape() {
    if (!more()) {
      fail("unexpected internal error");  // as Java says of a lone backslash
      return {};
    }
    if (take('b')) return {{Kind::word_edge, 0}};
    if (take('B')) return {{Kind::word_edge, 1}};
    if (take('A')) return {{Kind::line_begin}};
    if (take('z') || take('Z')) return {{Kind::line_end}};
    if (take('Q')) {
      Piece quoted;
      while (more() && !take("\\E")) append(quoted, literal(character()));
      return quoted;
    }
    Regex::CharacterClass set;
    if (predefined(set)) return one_of(std::move(set));
    return literal(escaped_character());
  }

  // \d \w \s \p{Upper} and their complements.
  bool predefined(Regex::CharacterClass& set) {
    const char name = pattern_[at_];
    if (name == 'p' || name == 'P') {
      ++at_;
      property(set);
      set.negated = name == 'P';
      return true;
    }
    switch (name) {
      case 'd':
      case 'D':
        set.ranges = {{'0', '9'}};
        break;
      case 'w':
      case 'W':
        set.ranges = {{'0', '9'}, {'A', 'Z'}, {'_', '_'}, {'a', 'z'}};
        break;
      case 's':
      case 'S':
        set.ranges = {{'\t', '\r'}, {' ', ' '}};
        break;
      default:
        return false;
    }
    set.negated = name < 'a';
    ++at_;
    return true;
  }

  void property(Regex::CharacterClass& set) {
    std::string_view name = pattern_.substr(at_).substr(0, 1);
    if (take('{')) {
      const std::size_t end = pattern_.find('}', at_);
      if (end == std::string_view::npos) {
        fail("unclosed character family");
        return;
      }
      name = pattern_.substr(at_, end - at_);
      at_ = end;
    }
    ++at_;
    const std::vector<Regex::Range> upper{{'A', 'Z'}};
    const std::vector<Regex::Range> lower{{'a', 'z'}};
    if (name == "Lu" || name == "Upper") {
      set.ranges = upper;
    } else if (name == "Ll" || name == "Lower") {
      set.ranges = lower;
    } else if (name == "Alpha") {
      set.ranges = {{'A', 'Z'}, {'a', 'z'}};
    } else if (name == "L" || name == "IsAlphabetic") {
      set.ranges = {{'A', 'Z'},    {'a', 'z'},      {0xC0, 0xD6},    {0xD8, 0xF6},
                    {0xF8, 0x2FF}, {0x370, 0x1FFF}, {0x3040, 0xD7FF}};
    } else if (name == "Digit" || name == "Nd" || name == "N") {
      set.ranges = {{'0', '9'}};
    } else if (name == "Alnum") {
      set.ranges = {{'0', '9'}, {'A', 'Z'}, {'a', 'z'}};
    } else if (name == "Punct" || name == "P") {
      set.ranges = {{'!', '/'}, {':', '@'}, {'[', '`'}, {'{', '~'}};
    } else if (name == "Space") {
      set.ranges = {{'\t', '\r'}, {' ', ' '}};
    } else {
      fail("unknown character property");
    }
  }

  char32_t escaped_character() {
    const char32_t c = character();
    switch (c) {
      case 'n':
        return '\n';
      case 't':
        return '\t';
      case 'r':
        return '\r';
      case 'f':
        return '\f';
      case 'a':
        return 7;
      case 'e':
        return 27;
      case 'x':
        return hexadecimal(2);
      case 'u':
        return hexadecimal(4);
      default:
        break;
    }
    if (is_word(c) && c != '_')
      fail(is_digit(c) ? "references to groups are not supported" : "illegal escape sequence");
    return c;
  }

  char32_t hexadecimal(int digits) {
    char32_t value = 0;
    for (int i = 0; i < digits; ++i) {
      const char32_t c = more() ? lower_case_of(character()) : U'!';
      if (!is_digit(c) && (c < 'a' || c > 'f')) {
        fail("illegal hexadecimal escape sequence");
        return 0;
      }
      value = value * 16 + (is_digit(c) ? c - '0' : c - 'a' + 10);
    }
    return value;
  }

  Regex::CharacterClass bracket() {
    Regex::CharacterClass set;
    set.negated = take('^');
    bool first = true;
    while (more() && (first || !next_is(']'))) {
      first = false;
      if (pattern_.substr(at_).starts_with("&&") || next_is('[')) {
        fail("unions and intersections of classes are not supported");
        return set;
      }
      char32_t begin = 0;
      if (take('\\')) {
        if (!more()) break;
        Regex::CharacterClass named;
        if (predefined(named)) {
          add_class(set, named);
          continue;
        }
        begin = escaped_character();
      } else {
        begin = character();
      }
      char32_t end = begin;
      if (next_is('-') && at_ + 1 < pattern_.size() && pattern_[at_ + 1] != ']') {
        ++at_;
        end = take('\\') && more() ? escaped_character() : character();
        if (end < begin) fail("illegal character range");
      }
      set.ranges.push_back({begin, end});
    }
    if (!take(']')) fail("unclosed character class");
    return set;
  }

  static void add_class(Regex::CharacterClass& set, const Regex::CharacterClass& named) {
    if (!named.negated) {
      set.ranges.insert(set.ranges.end(), named.ranges.begin(), named.ranges.end());
      return;
    }
    char32_t next = 0;  // the gaps between the ranges, which are in order
    for (const Regex::Range& range : named.ranges) {
      if (range.first > next) set.ranges.push_back({next, range.first - 1});
      next = range.last + 1;
    }
    set.ranges.push_back({next, 0x10FFFF});
  }

  std::string_view pattern_;
  Regex& regex_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool fold_case_ = false;
  std::string error_;
};

// One search: the threads that are alive at a position, in the order of their priority.
class RegexRun {
 public:
  RegexRun(const Regex& regex, std::string_view text)
      : regex_(regex), text_(text), last_seen_(regex.program_.size(), Regex::kNone) {}

  Regex::Groups run(std::size_t from, bool anchored) {
    std::vector<Thread> now;
    std::vector<Thread> next;
    Regex::Groups found;
    for (std::size_t at = from;;) {
      if (found.empty() && (!anchored || at == from)) {
        add(now, {0, Regex::Groups(2 * regex_.groups_, Regex::kNone)}, at);
      }
      if (now.empty() && (!found.empty() || anchored)) return found;
      std::size_t size = 1;
      const bool at_end = at >= text_.size();
      const char32_t character = at_end ? 0 : character_at(text_, at, size);
      ++generation_;
      for (Thread& thread : now) {
        const Regex::Instruction& instruction = regex_.program_[thread.at];
        if (instruction.kind == Regex::Instruction::Kind::match) {
          if (anchored && !at_end) continue;
          found = std::move(thread.groups);
          break;  // the threads behind this one matter no more
        }
        if (!at_end && accepts(instruction, character)) {
          add(next, {thread.at + 1, std::move(thread.groups)}, at + size);
        }
      }
      if (at_end) return found;
      at += size;
      now.clear();
      std::swap(now, next);
    }
  }

 private:
  using Kind = Regex::Instruction::Kind;
  struct Thread {
    std::uint32_t at;
    Regex::Groups groups;
  };

  bool accepts(const Regex::Instruction& instruction, char32_t character) const {
    if (instruction.kind == Kind::any) return !is_line_end(character);
    return regex_.classes_[instruction.x].contains(character);
  }

  // Follows what takes no character. The stack is ours: programs may be long.
  void add(std::vector<Thread>& threads, Thread thread, std::size_t at) {
    std::vector<Thread> stack;
    stack.push_back(std::move(thread));
    while (!stack.empty()) {
      Thread top = std::move(stack.back());
      stack.pop_back();
      if (last_seen_[top.at] == generation_) continue;
      last_seen_[top.at] = generation_;
      const Regex::Instruction& instruction = regex_.program_[top.at];
      switch (instruction.kind) {
        case Kind::jump:
          stack.push_back({instruction.x, std::move(top.groups)});
          break;
        case Kind::split:
          stack.push_back({instruction.y, top.groups});
          stack.push_back({instruction.x, std::move(top.groups)});
          break;
        case Kind::save:
          top.groups[instruction.x] = at;
          stack.push_back({top.at + 1, std::move(top.groups)});
          break;
        case Kind::line_begin:
          if (at == 0) stack.push_back({top.at + 1, std::move(top.groups)});
          break;
        case Kind::line_end:
          if (at == text_.size() || (at + 1 == text_.size() && text_[at] == '\n')) {
            stack.push_back({top.at + 1, std::move(top.groups)});
          }
          break;
        case Kind::word_edge:
          if (is_edge(at) != (instruction.x == 1)) {
            stack.push_back({top.at + 1, std::move(top.groups)});
          }
          break;
        default:
          threads.push_back(std::move(top));
          break;
      }
    }
  }

  bool is_edge(std::size_t at) const {
    const bool before = at > 0 && is_word(static_cast<unsigned char>(text_[at - 1]));
    const bool behind = at < text_.size() && is_word(static_cast<unsigned char>(text_[at]));
    return before != behind;
  }

  const Regex& regex_;
  std::string_view text_;
  std::vector<std::size_t> last_seen_;  // the step in which an instruction was last reached
  std::size_t generation_ = 0;
};

bool Regex::CharacterClass::contains(char32_t character) const {
  const auto holds = [this](char32_t c) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [c](const Range& range) { return range.first <= c && c <= range.last; });
  };
  const bool found =
      holds(character) ||
      (fold_case && (holds(lower_case_of(character)) || holds(upper_case_of(character))));
  return found != negated;
}

std::optional<Regex> Regex::parse(std::string_view pattern, std::string& error) {
  Regex regex;
  if (!RegexParser(pattern, regex).parse(error)) return std::nullopt;
  return regex;
}

Regex::Groups Regex::find(std::string_view text, std::size_t from) const {
  return RegexRun(*this, text).run(from, false);
}

bool Regex::matches(std::string_view text) const {
  return !RegexRun(*this, text).run(0, true).empty();
}

std::optional<std::string> Regex::replace_all(std::string_view text, std::string_view replacement,
                                              std::string& error) const {
  std::string out;
  std::size_t from = 0;
  std::size_t copied = 0;
  while (from <= text.size()) {
    const Groups groups = find(text, from);
    if (groups.empty()) break;
    out += text.substr(copied, groups[0] - copied);
    for (std::size_t i = 0; i < replacement.size(); ++i) {
      if (replacement[i] == '\\' && i + 1 < replacement.size()) {
        out += replacement[++i];
      } else if (replacement[i] == '$') {
        const std::size_t group =
            i + 1 < replacement.size() && is_digit(static_cast<unsigned char>(replacement[i + 1]))
                ? static_cast<std::size_t>(replacement[i + 1] - '0')
                : groups_;
        if (group >= groups_) {
          error = "no group of the pattern for '$' in the replacement";
          return std::nullopt;
        }
        ++i;
        if (groups[2 * group] != kNone) {
          out += text.substr(groups[2 * group], groups[2 * group + 1] - groups[2 * group]);
        }
      } else {
        out += replacement[i];
      }
    }
    if (out.size() > kMaxTextBytes) {
      error = "the text is longer than 64 MB";
      return std::nullopt;
    }
    copied = groups[1];
    from = groups[1];
    if (groups[0] == groups[1]) {  // an empty match: the next one begins a character later
      std::size_t size = 1;
      if (from < text.size()) (void)character_at(text, from, size);
      from += size;
    }
  }
  out += text.substr(std::min(copied, text.size()));
  return out;
}

}  // namespace jaywalk::actions
