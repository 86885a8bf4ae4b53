// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/java/java_regex.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <utility>

#include <fmt/format.h>
#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>

#include "interpreter/actions/java/java_text.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

// A search that needs more ends with an error, after about a second or at so much memory.
constexpr std::uint32_t kMostSteps = 5'000'000;
constexpr std::uint32_t kMostMemoryKb = 64 * 1024;
constexpr std::size_t kMostBytesOfPattern = 64 * 1024;
constexpr std::uint32_t kStepsBetweenLooks = 4096;
constexpr std::string_view kDigits = "0123456789";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Java's name of a set of ASCII, as PCRE2 calls it within a class; empty: another name.
std::string_view posix_name(std::string_view name) {
  using Row = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Row, 13> kNames{{{"Lower", "lower"},
                                        {"Upper", "upper"},
                                        {"ASCII", "ascii"},
                                        {"Alpha", "alpha"},
                                        {"Digit", "digit"},
                                        {"Alnum", "alnum"},
                                        {"Punct", "punct"},
                                        {"Graph", "graph"},
                                        {"Print", "print"},
                                        {"Blank", "blank"},
                                        {"Cntrl", "cntrl"},
                                        {"XDigit", "xdigit"},
                                        {"Space", "space"}}};
  const auto* const row = std::find_if(kNames.begin(), kNames.end(),
                                       [&](const Row& each) { return each.first == name; });
  return row == kNames.end() ? std::string_view() : row->second;
}

// Copies a pattern of Java's, and changes what PCRE2 reads otherwise.
class Translation {
 public:
  explicit Translation(std::string_view pattern) : pattern_(pattern) {}

  [[nodiscard]] std::string run() {
    while (more()) {
      const char c = pattern_[at_];
      if (c == '\\') {
        escape();
      } else if (in_class_) {
        within_class(c);
      } else if (c == '[') {
        in_class_ = true;
        copy(pattern_.substr(at_).starts_with("[^") ? 2 : 1);
        if (next_is(']')) copy(1);  // a bracket that comes first stands for itself
      } else if (c == '(') {
        group();
      } else if (c == '{') {
        repetition();
      } else {
        copy(1);
      }
    }
    if (in_class_) fail("unclosed character class");
    return std::move(out_);
  }
  /// Why the pattern is refused; empty if it is not.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  [[nodiscard]] bool more() const { return at_ < pattern_.size(); }
  [[nodiscard]] bool next_is(char c) const { return more() && pattern_[at_] == c; }
  [[nodiscard]] std::size_t end_of_digits(std::size_t from) const {
    return std::min(pattern_.find_first_not_of(kDigits, from), pattern_.size());
  }
  void copy(std::size_t bytes) {
    out_ += pattern_.substr(at_, bytes);
    at_ = std::min(at_ + bytes, pattern_.size());
  }
  void fail(std::string_view why) {
    if (error_.empty()) error_ = fmt::format("{} near index {}", why, at_);
    at_ = pattern_.size();
  }

  void within_class(char c) {
    if (c == '[' || pattern_.substr(at_).starts_with("&&")) {
      return fail("unions and intersections of classes are not supported");
    }
    in_class_ = c != ']';
    copy(1);
  }

  // Groups that both languages have; of the flags `i`, `m` and `s`.
  void group() {
    const std::string_view rest = pattern_.substr(at_);
    if (rest.starts_with("(*")) return fail("dangling meta character '*'");
    const bool is_plain = !rest.starts_with("(?");
    const bool is_named = rest.starts_with("(?<") && rest.size() > 3 && is_letter(rest[3]);
    if (is_plain || is_named) {
      ++groups_;
      return copy(1);
    }
    for (const std::string_view kind : {"(?:", "(?=", "(?!", "(?>", "(?<=", "(?<!"}) {
      if (rest.starts_with(kind)) return copy(kind.size());
    }
    const std::size_t end = rest.find_first_not_of("ims-", 2);
    if (end == rest.npos || end == 2 || (rest[end] != ')' && rest[end] != ':')) {
      return fail("this kind of group is not supported");
    }
    copy(end);
  }

  // `{2}`, `{2,}`, `{2,3}`; any other brace is an error of Java's.
  void repetition() {
    std::size_t end = end_of_digits(at_ + 1);
    if (end == at_ + 1) return fail("illegal repetition");
    if (pattern_.substr(end).starts_with(',')) end = end_of_digits(end + 1);
    if (!pattern_.substr(end).starts_with('}')) return fail("unclosed counted closure");
    copy(end + 1 - at_);
  }

  void escape() {
    if (at_ + 1 == pattern_.size()) return fail("a backslash at the end");
    const char c = pattern_[at_ + 1];
    if (c == 'Q') return copy(std::min(pattern_.find("\\E", at_), pattern_.size()) - at_ + 2);
    if (c == 'c') return copy(3);
    if (c == 'u') return unicode();
    if (c == 'p' || c == 'P') return property(c == 'P');
    if (c >= '1' && c <= '9' && !in_class_) return reference();
    constexpr std::string_view kSame = "tnrfae0xdDsSwWhHvV";
    constexpr std::string_view kSameOutside = "RXbBAZzk";
    const bool is_known =
        kSame.find(c) != kSame.npos || (!in_class_ && kSameOutside.find(c) != kSameOutside.npos);
    if ((is_letter(c) || (c >= '1' && c <= '9')) && !is_known)
      return fail("illegal escape sequence");
    copy(2);
  }

  void unicode() {
    const std::string_view digits = pattern_.substr(at_ + 2, 4);
    if (digits.find_first_not_of("0123456789abcdefABCDEF") != digits.npos || digits.size() < 4) {
      return fail("illegal Unicode escape sequence");
    }
    out_ += fmt::format("\\x{{{}}}", digits);
    at_ += 6;
  }

  // `\p{Upper}` and its like are sets of ASCII, `\p{IsGreek}` and `\p{Lu}` of Unicode.
  void property(bool is_negated) {
    const bool has_brace = pattern_.substr(at_ + 2).starts_with('{');
    const std::size_t begin = at_ + (has_brace ? 3 : 2);
    const std::size_t end = has_brace ? pattern_.find('}', begin) : begin + 1;
    if (end == pattern_.npos) return fail("unclosed character family");
    std::string_view name = pattern_.substr(begin, end - begin);
    const std::string_view posix = posix_name(name);
    if (name.starts_with("Is")) name.remove_prefix(2);
    if (posix.empty()) {
      out_ += fmt::format("\\{}{{{}}}", is_negated ? 'P' : 'p', name);
    } else {
      const std::string set = fmt::format("[:{}{}:]", is_negated ? "^" : "", posix);
      out_ += in_class_ ? set : fmt::format("[{}]", set);
    }
    at_ = end + (has_brace ? 1 : 0);
  }

  // `\12` is group 12 if 12 groups begin before it, else group 1 and a 2.
  void reference() {
    std::size_t group = static_cast<std::size_t>(pattern_[++at_] - '0');
    for (++at_; more() && kDigits.find(pattern_[at_]) != kDigits.npos; ++at_) {
      const std::size_t longer = group * 10 + static_cast<std::size_t>(pattern_[at_] - '0');
      if (longer > groups_) break;
      group = longer;
    }
    out_ += fmt::format("\\g{{{}}}", group);
  }

  std::string_view pattern_;
  std::string out_;
  std::size_t at_ = 0;
  std::size_t groups_ = 0;  // opened so far
  bool in_class_ = false;
  std::string error_;
};

std::string message_of(int code) {
  std::array<PCRE2_UCHAR, 256> text{};
  pcre2_get_error_message(code, text.data(), text.size());
  return reinterpret_cast<const char*>(text.data());
}

PCRE2_SPTR bytes_of(std::string_view text) {
  return reinterpret_cast<PCRE2_SPTR>(text.data() == nullptr ? "" : text.data());
}

struct Deleter {
  void operator()(pcre2_code* code) const { pcre2_code_free(code); }
  void operator()(pcre2_match_data* match) const { pcre2_match_data_free(match); }
  void operator()(pcre2_match_context* context) const { pcre2_match_context_free(context); }
};

}  // namespace

struct Regex::Code {
  std::unique_ptr<pcre2_code, Deleter> code;
};

// Searches in one text, each with the same limits.
class Regex::Search {
 public:
  Search(const Regex& regex, std::string_view text)
      : code_(regex.code_->code.get()),
        text_(text),
        look_(regex.look_),
        match_(pcre2_match_data_create_from_pattern(code_, nullptr)),
        context_(pcre2_match_context_create(nullptr)) {
    pcre2_set_match_limit(context_.get(), kMostSteps);
    pcre2_set_heap_limit(context_.get(), kMostMemoryKb);
    if (look_) pcre2_set_callout(context_.get(), look, this);
  }

  // The first match at or after a byte. False without one, and with an error.
  bool find(std::size_t from, std::uint32_t options, std::string& error) {
    // The first search finds out whether the text is UTF-8.
    const std::uint32_t check = checked_ ? PCRE2_NO_UTF_CHECK : 0;
    const int found = pcre2_match(code_, bytes_of(text_), text_.size(), from, options | check,
                                  match_.get(), context_.get());
    if (thrown_) std::rethrow_exception(thrown_);
    checked_ = true;
    if (found >= 0 || found == PCRE2_ERROR_NOMATCH) return found >= 0;
    error = found <= PCRE2_ERROR_UTF8_ERR1 && found >= PCRE2_ERROR_UTF8_ERR21
                ? "the text is not UTF-8"
                : "the search takes too many steps";
    return false;
  }
  [[nodiscard]] std::size_t begin() const { return pcre2_get_ovector_pointer(match_.get())[0]; }
  [[nodiscard]] std::size_t end() const { return pcre2_get_ovector_pointer(match_.get())[1]; }

  // What stands for the match; false with an error if the replacement is wrong.
  bool append(std::string_view replacement, std::string& out, std::string& error) const {
    for (std::size_t i = 0; i < replacement.size(); ++i) {
      const char c = replacement[i];
      if (c == '$') {
        const std::optional<std::size_t> number = group_number(replacement, i);
        if (!number) {
          error = "no group of the pattern for '$' in the replacement";
          return false;
        }
        out += group(*number);
      } else if (c != '\\') {
        out += c;
      } else if (++i < replacement.size()) {
        out += replacement[i];
      } else {
        error = "a backslash at the end of the replacement";
        return false;
      }
    }
    return true;
  }

 private:
  static int look(pcre2_callout_block* /*block*/, void* data) {
    auto& search = *static_cast<Search*>(data);
    if (++search.steps_ % kStepsBetweenLooks != 0) return 0;
    try {
      search.look_();
    } catch (...) {
      search.thrown_ = std::current_exception();
      return PCRE2_ERROR_CALLOUT;
    }
    return 0;
  }

  // Empty for a group that took no part.
  [[nodiscard]] std::string_view group(std::size_t number) const {
    const std::size_t* const ends = pcre2_get_ovector_pointer(match_.get()) + 2 * number;
    return ends[0] == PCRE2_UNSET ? std::string_view() : text_.substr(ends[0], ends[1] - ends[0]);
  }

  // The group for `$1` or `${name}`, of which `at` then is the last byte.
  [[nodiscard]] std::optional<std::size_t> group_number(std::string_view text,
                                                        std::size_t& at) const {
    const std::size_t groups = pcre2_get_ovector_count(match_.get());
    std::size_t group = groups;
    if (text.substr(at + 1).starts_with('{')) {
      const std::size_t close = text.find('}', at);
      if (close == text.npos) return std::nullopt;
      const std::string name(text.substr(at + 2, close - at - 2));
      const int number = pcre2_substring_number_from_name(code_, bytes_of(name));
      if (number < 0) return std::nullopt;
      at = close;
      return static_cast<std::size_t>(number);
    }
    // Further digits belong to it as long as there is such a group.
    while (at + 1 < text.size() && kDigits.find(text[at + 1]) != kDigits.npos) {
      const auto digit = static_cast<std::size_t>(text[at + 1] - '0');
      const std::size_t longer = group == groups ? digit : group * 10 + digit;
      if (longer >= groups) break;
      group = longer;
      ++at;
    }
    return group < groups ? std::optional(group) : std::nullopt;
  }

  const pcre2_code* code_;
  std::string_view text_;
  std::function<void()> look_;
  std::unique_ptr<pcre2_match_data, Deleter> match_;
  std::unique_ptr<pcre2_match_context, Deleter> context_;
  std::uint32_t steps_ = 0;
  bool checked_ = false;
  std::exception_ptr thrown_;
};

std::optional<Regex> Regex::parse(std::string_view pattern, std::string& error) {
  Translation translation(pattern);
  const std::string translated = translation.run();
  error = translation.error();
  if (!error.empty()) return std::nullopt;
  const std::unique_ptr<pcre2_compile_context, decltype(&pcre2_compile_context_free)> context(
      pcre2_compile_context_create(nullptr), pcre2_compile_context_free);
  pcre2_set_max_pattern_length(context.get(), kMostBytesOfPattern);
  pcre2_set_newline(context.get(), PCRE2_NEWLINE_ANY);
#if PCRE2_MAJOR > 10 || PCRE2_MINOR >= 43
  pcre2_set_max_varlookbehind(context.get(), 0);  // the same patterns as before 10.43
#endif
  int code = 0;
  std::size_t offset = 0;
  auto compiled = std::make_shared<Code>();
  compiled->code.reset(pcre2_compile(bytes_of(translated), translated.size(),
                                     PCRE2_UTF | PCRE2_AUTO_CALLOUT, &code, &offset,
                                     context.get()));
  if (compiled->code == nullptr) {
    error = fmt::format("{} near index {}", message_of(code), offset);
    return std::nullopt;
  }
  return Regex(std::move(compiled));
}

bool Regex::matches(std::string_view text, std::string& error) const {
  return Search(*this, text).find(0, PCRE2_ANCHORED | PCRE2_ENDANCHORED, error);
}

std::optional<std::string> Regex::replace_all(std::string_view text, std::string_view replacement,
                                              std::string& error) const {
  error.clear();
  Search search(*this, text);
  std::string out;
  std::size_t copied = 0;
  for (std::size_t from = 0; from <= text.size() && search.find(from, 0, error);) {
    out += text.substr(copied, search.begin() - copied);
    if (!search.append(replacement, out, error)) return std::nullopt;
    if (out.size() > kMaxTextBytes) {
      error = "the text is longer than 64 MB";
      return std::nullopt;
    }
    copied = search.end();
    from = copied;
    if (search.begin() == copied) {  // an empty match: the next one begins a character later
      std::size_t size = 1;
      if (from < text.size()) (void)character_at(text, from, size);
      from += size;
    }
  }
  if (!error.empty()) return std::nullopt;
  out += text.substr(copied);
  return out;
}

}  // namespace jaywalk::actions
