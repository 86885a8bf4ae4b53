// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/repl/line_editor.h"

#include <cstdio>
#include <cstdlib>
#include <histedit.h>
#include <system_error>
#include <utility>

#include "experiment/scenario/files/temporary.h"

namespace jaywalk {
namespace {

constexpr int kRemembered = 1000;

// libedit passes only the editor to functions; this is its client data, which they need.
struct EditorState {
  std::string prompt;
  bool cancelled = false;
  std::function<Completion(std::string_view before)> complete;
};

EditorState& state_of(EditLine* editor) {
  void* state = nullptr;
  el_get(editor, EL_CLIENTDATA, &state);
  return *static_cast<EditorState*>(state);
}

char* prompt_of(EditLine* editor) { return state_of(editor).prompt.data(); }

unsigned char cancel_line(EditLine* editor, int /*key*/) {
  state_of(editor).cancelled = true;
  return CC_NEWLINE;
}

// Inserts a single candidate, or the common beginning of all; else shows the candidates below.
unsigned char complete_word(EditLine* editor, int /*key*/) {
  const EditorState& state = state_of(editor);
  if (!state.complete) return CC_REFRESH_BEEP;
  const LineInfo* const line = el_line(editor);
  const Completion found =
      state.complete({line->buffer, static_cast<std::size_t>(line->cursor - line->buffer)});
  if (found.candidates.empty()) return CC_REFRESH_BEEP;
  const std::string missing = found.common().substr(found.replaced);
  if (!missing.empty()) {
    return el_insertstr(editor, missing.c_str()) == 0 ? CC_REFRESH : CC_REFRESH_BEEP;
  }
  if (found.candidates.size() == 1) return CC_REFRESH;
  std::fputc('\n', stdout);
  for (const std::string& candidate : found.candidates) std::printf("%s  ", candidate.c_str());
  std::fputc('\n', stdout);
  return CC_REDISPLAY;
}

class TerminalReader : public LineReader {
 public:
  explicit TerminalReader(std::optional<std::filesystem::path> history_file)
      : history_file_(std::move(history_file)),
        editor_(el_init("jaywalk", stdin, stdout, stderr), el_end),
        history_(history_init(), history_end) {
    HistEvent event;
    history(history_.get(), &event, H_SETSIZE, kRemembered);
    if (history_file_) history(history_.get(), &event, H_LOAD, history_file_->c_str());
    EditLine* const editor = editor_.get();
    el_set(editor, EL_CLIENTDATA, &state_);
    el_set(editor, EL_PROMPT, prompt_of);
    el_set(editor, EL_EDITOR, "emacs");
    el_set(editor, EL_HIST, history, history_.get());
    // Ctrl-C is a key while a line is typed; it is a signal while an agent reasons.
    el_set(editor, EL_SETTY, "-d", "-isig", nullptr);
    el_set(editor, EL_ADDFN, "jaywalk-cancel", "Give up the input", cancel_line);
    el_set(editor, EL_BIND, "^C", "jaywalk-cancel", nullptr);
    el_set(editor, EL_ADDFN, "jaywalk-complete", "Complete the word", complete_word);
    el_set(editor, EL_BIND, "^I", "jaywalk-complete", nullptr);
  }

  std::optional<Line> read(const std::string& prompt) override {
    state_.prompt = prompt;
    state_.cancelled = false;
    // Libedit would show the prompt first: a key typed then was lost, and Ctrl-C was a signal.
    el_set(editor_.get(), EL_PREP_TERM, 1);
    int count = 0;
    const char* const text = el_gets(editor_.get(), &count);
    // Libedit gives no text for an empty line, whether Ctrl-C or Ctrl-D ended it.
    if (state_.cancelled) {
      std::fputc('\n', stdout);
      return Line{.text = {}, .cancelled = true};
    }
    if (text == nullptr || count <= 0) {
      std::fputc('\n', stdout);
      return std::nullopt;
    }
    std::string line(text, static_cast<std::size_t>(count));
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return Line{.text = std::move(line)};
  }

  void remember(const std::string& input) override {
    HistEvent event;
    history(history_.get(), &event, H_ENTER, input.c_str());
    keep_history();
  }

  void complete_with(std::function<Completion(std::string_view before)> complete) override {
    state_.complete = std::move(complete);
  }

 private:
  // Written whole, then renamed. A history that cannot be kept is no reason to disturb.
  void keep_history() {
    if (!history_file_) return;
    PartFile fresh(history_file_->string());
    if (!fresh.is_open()) return;
    HistEvent event;
    if (history(history_.get(), &event, H_SAVE, fresh.name().c_str()) >= 0) (void)fresh.replace();
  }

  std::optional<std::filesystem::path> history_file_;
  EditorState state_;
  std::unique_ptr<EditLine, void (*)(EditLine*)> editor_;
  std::unique_ptr<History, void (*)(History*)> history_;
};

class StreamReader : public LineReader {
 public:
  explicit StreamReader(std::istream& stream) : stream_(stream) {}

  std::optional<Line> read(const std::string& /*prompt*/) override {
    Line line;
    if (!std::getline(stream_, line.text)) return std::nullopt;
    if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
    return line;
  }
  void remember(const std::string& /*input*/) override {}
  void complete_with(std::function<Completion(std::string_view)> /*complete*/) override {}

 private:
  std::istream& stream_;
};

namespace fs = std::filesystem;

/// Ignores a relative path in XDG_STATE_HOME, as the standard demands.
std::optional<fs::path> state_folder() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state);
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return std::nullopt;
  return fs::path(home) / ".local" / "state";
}

}  // namespace

std::unique_ptr<LineReader> terminal_reader(
    const std::optional<std::filesystem::path>& history_file) {
  return std::make_unique<TerminalReader>(history_file);
}

std::unique_ptr<LineReader> stream_reader(std::istream& stream) {
  return std::make_unique<StreamReader>(stream);
}

std::optional<fs::path> repl_history_file() {
  const auto folder = state_folder();
  if (!folder) return std::nullopt;
  std::error_code problem;
  fs::create_directories(*folder / "jaywalk", problem);
  if (problem) return std::nullopt;
  const fs::path file = *folder / "jaywalk" / "repl_history";
  // A pipe would be waited for, a device read without end.
  const fs::file_status status = fs::status(file, problem);
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;
  return file;
}

}  // namespace jaywalk
