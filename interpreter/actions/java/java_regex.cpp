#include "interpreter/actions/java/java_regex.h"

#include <algorithm>
#include <utility>

#include "interpreter/actions/java/java_text.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

bool is_line_end(char32_t c) {
  return c == '\n' || c == '\r' || c == 0x85 || c == 0x2028 || c == 0x2029;
}

}  // namespace

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
  void look_now_and_then() {
    constexpr std::size_t kStepsBetweenLooks = 16 * 1024;
    if (++steps_ % kStepsBetweenLooks == 0 && regex_.look_) regex_.look_();
  }

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
      look_now_and_then();
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
  std::size_t steps_ = 0;
};

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
