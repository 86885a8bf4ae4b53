// Patterns become programs. The error is Java's where Java has one.

#include <utility>

#include "interpreter/actions/java/java_regex.h"
#include "interpreter/actions/java/java_text.h"

namespace jaywalk::actions {
namespace {

constexpr std::size_t kMaxProgram = 20'000;
constexpr std::uint32_t kMaxRepeat = 1000;
constexpr int kMaxDepth = 200;

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
    // Group 0 is the whole match.
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
      // split to left or right; behind left a jump over right.
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
    // Without a limit: split into the piece or behind it, and back.
    if (most > kMaxRepeat) {
      Piece loop{split(1, size + 2)};
      append(loop, piece);
      loop.push_back({Kind::jump, 0});
      append(all, loop);
      return all;
    }
    // Each further one may be left out, and with it all that follow.
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
      // The flag holds to the end of the group around it, which restores its own.
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
    // Numbered by their opening parentheses, so before the inner groups.
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

  Piece one_of(CharacterClass set) {
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
    CharacterClass set;
    if (predefined(set)) return one_of(std::move(set));
    return literal(escaped_character());
  }

  // \d \w \s \p{Upper} and their complements.
  bool predefined(CharacterClass& set) {
    const char name = pattern_[at_];
    if (name == 'p' || name == 'P') {
      ++at_;
      property(set);
      set.negated = name == 'P';
      return true;
    }
    const std::optional<CharacterClass> found = predefined_class(name);
    if (!found) return false;
    set = *found;
    ++at_;
    return true;
  }

  void property(CharacterClass& set) {
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
    const std::optional<CharacterClass> found = class_of_property(name);
    if (found) {
      set = *found;
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

  CharacterClass bracket() {
    CharacterClass set;
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
        CharacterClass named;
        if (predefined(named)) {
          set.add(named);
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

  std::string_view pattern_;
  Regex& regex_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool fold_case_ = false;
  std::string error_;
};

std::optional<Regex> Regex::parse(std::string_view pattern, std::string& error) {
  Regex regex;
  if (!RegexParser(pattern, regex).parse(error)) return std::nullopt;
  return regex;
}

}  // namespace jaywalk::actions
