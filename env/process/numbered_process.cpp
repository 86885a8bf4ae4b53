// SPDX-License-Identifier: Apache-2.0
#include "env/process/numbered_process.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

// Few enough that their answers fit into the socket's buffer until we read them.
constexpr std::size_t kAtOnce = 64;

std::string joined(std::span<const std::string> lines) {
  std::string text;
  for (const std::string& line : lines) {
    if (!text.empty()) text += '\n';
    text += line;
  }
  return text;
}

/// The object as one line. Names of files may be any bytes; invalid UTF-8 becomes U+FFFD.
std::string text_of(const nlohmann::json& line) {
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

NumberedProcess::NumberedProcess(Settings settings)
    : settings_(std::move(settings)), process_(settings_.command, settings_.folder) {}

JsonAnswer NumberedProcess::ask(nlohmann::json question, std::size_t number,
                                std::chrono::milliseconds limit) {
  const std::string key(settings_.key);
  question[key] = number;
  return ask_text(text_of(question), number, limit);
}

JsonAnswer NumberedProcess::ask_text(std::string_view question, std::size_t number,
                                     std::chrono::milliseconds limit) {
  JsonAnswer answer = read(process_.ask(question, limit), number);
  if (!answer.error.empty()) return answer;
  // Output that comes later is noticed at the next question, where a repeated number identifies it.
  std::string more =
      repeats_ ? complaint(process_.unasked_so_far()) : said_more(settings_.settling);
  if (!more.empty()) return {{}, std::move(more)};
  return answer;
}

std::vector<JsonAnswer> NumberedProcess::ask_texts(std::span<const std::string> questions,
                                                   std::size_t first,
                                                   std::chrono::milliseconds limit) {
  std::vector<JsonAnswer> answers;
  while (answers.size() < questions.size()) {
    const std::size_t done = answers.size();
    // Without numbers the answers could not be matched to questions.
    const std::size_t count = repeats_ ? std::min(kAtOnce, questions.size() - done) : 1;
    if (count == 1) {
      answers.push_back(ask_text(questions[done], first + done, limit));
    } else {
      LineAnswer sent = process_.send_lines(joined(questions.subspan(done, count)), limit);
      for (std::size_t i = 0; i < count; ++i) {
        LineAnswer line = sent.error.empty() ? process_.next_answer(limit) : std::move(sent);
        answers.push_back(read(std::move(line), first + done + i));
        if (!answers.back().error.empty()) return answers;
      }
    }
    if (!answers.back().error.empty()) return answers;
  }
  return answers;
}

JsonAnswer NumberedProcess::read(LineAnswer answer, std::size_t number) {
  asked_ = answer.error.empty();
  if (!answer.error.empty()) {
    repeats_ = false;
    return {{}, std::move(answer.error), !answer.unasked};
  }
  last_ = std::move(answer.line);
  nlohmann::json json = nlohmann::json::parse(last_, nullptr, false);
  if (!json.is_object()) return {{}, refuse("expected a JSON object")};
  if (std::string why = mismatch(json, number); !why.empty()) return {{}, refuse(why)};
  return {std::move(json), {}};
}

std::string NumberedProcess::said_more(std::chrono::milliseconds settling) {
  return asked_ ? complaint(process_.unasked(settling)) : std::string();
}

/// Empty if there is no such text.
std::string NumberedProcess::complaint(const std::optional<std::string>& text) {
  if (!text) return {};
  return refuse(
      fmt::format("one line is an answer, but it also wrote '{}'", shortened(*text, kMostQuoted)));
}

void NumberedProcess::tell(const nlohmann::json& line, std::chrono::milliseconds limit) {
  process_.tell(text_of(line), limit);
}

std::string NumberedProcess::mismatch(const nlohmann::json& answer, std::size_t number) {
  const auto repeated = answer.find(settings_.key);
  if (repeated == answer.end()) {
    return repeats_ ? fmt::format("there is no '{}', which it had repeated before", settings_.key)
                    : std::string();
  }
  if (!repeated->is_number_integer() || *repeated != number) {
    return fmt::format("it answers {} {}, expected {}", settings_.key, repeated->dump(), number);
  }
  repeats_ = true;
  return {};
}

std::string NumberedProcess::refuse(std::string_view why) {
  const std::size_t line = process_.lines();
  process_.give_up();
  asked_ = false;
  repeats_ = false;
  return fmt::format("line {} of its output, '{}': {}", line, shortened(last_, kMostQuoted), why);
}

double tidy(double value) {
  constexpr double kDigits = 1e9;
  return std::round(value * kDigits) / kDigits + 0.0;
}

nlohmann::json tidy_pair(double first, double second) { return {tidy(first), tidy(second)}; }

}  // namespace jaywalk
