#include "tools/jaywalk/line_editor.h"

#include <cstdio>
#include <histedit.h>

namespace jaywalk {
namespace {

constexpr int kRemembered = 1000;

// libedit calls functions with the editor alone; what they need is its client data.
struct EditorState {
  std::string prompt;
  bool cancelled = false;
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

class TerminalReader : public LineReader {
 public:
  TerminalReader()
      : editor_(el_init("jaywalk", stdin, stdout, stderr), el_end),
        history_(history_init(), history_end) {
    HistEvent event;
    history(history_.get(), &event, H_SETSIZE, kRemembered);
    EditLine* const editor = editor_.get();
    el_set(editor, EL_CLIENTDATA, &state_);
    el_set(editor, EL_PROMPT, prompt_of);
    el_set(editor, EL_EDITOR, "emacs");
    el_set(editor, EL_HIST, history, history_.get());
    // Ctrl-C is a key while a line is typed; it is a signal while an agent reasons.
    el_set(editor, EL_SETTY, "-d", "-isig", nullptr);
    el_set(editor, EL_ADDFN, "jaywalk-cancel", "Give up the input", cancel_line);
    el_set(editor, EL_BIND, "^C", "jaywalk-cancel", nullptr);
  }

  std::optional<Line> read(const std::string& prompt) override {
    state_.prompt = prompt;
    state_.cancelled = false;
    // Libedit would show the prompt first: a key typed then was lost, and Ctrl-C was a signal.
    el_set(editor_.get(), EL_PREP_TERM, 1);
    int count = 0;
    const char* const text = el_gets(editor_.get(), &count);
    if (text == nullptr || (count <= 0 && !state_.cancelled)) {
      std::fputc('\n', stdout);
      return std::nullopt;
    }
    if (state_.cancelled) {
      std::fputc('\n', stdout);
      return Line{.text = {}, .cancelled = true};
    }
    std::string line(text, static_cast<std::size_t>(count));
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return Line{.text = std::move(line)};
  }

  void remember(const std::string& input) override {
    HistEvent event;
    history(history_.get(), &event, H_ENTER, input.c_str());
  }

 private:
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

 private:
  std::istream& stream_;
};

}  // namespace

std::unique_ptr<LineReader> terminal_reader() { return std::make_unique<TerminalReader>(); }

std::unique_ptr<LineReader> stream_reader(std::istream& stream) {
  return std::make_unique<StreamReader>(stream);
}

}  // namespace jaywalk
