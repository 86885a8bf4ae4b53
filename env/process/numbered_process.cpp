#include "env/process/numbered_process.h"

#include <utility>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

/// One line. Names of files may be any bytes; what is not UTF-8 becomes U+FFFD.
std::string text_of(const nlohmann::json& line) {
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

NumberedProcess::NumberedProcess(Settings settings)
    : settings_(std::move(settings)),
      process_(settings_.command, settings_.folder, settings_.errors) {}

JsonAnswer NumberedProcess::ask(nlohmann::json question, std::size_t number,
                                std::chrono::milliseconds limit) {
  const std::string key(settings_.key);
  question[key] = number;
  return ask_text(text_of(question), number, limit);
}

JsonAnswer NumberedProcess::ask_text(std::string_view question, std::size_t number,
                                     std::chrono::milliseconds limit) {
  LineAnswer answer = process_.ask(question, limit);
  asked_ = answer.error.empty();
  if (!answer.error.empty()) {
    repeats_ = false;
    return {{}, std::move(answer.error), !answer.unasked};
  }
  last_ = std::move(answer.line);
  nlohmann::json json = nlohmann::json::parse(last_, nullptr, false);
  if (!json.is_object()) return {{}, refuse("expected a JSON object")};
  if (std::string why = mismatch(json, number); !why.empty()) return {{}, refuse(why)};
  std::string more = said_more(repeats_ ? std::chrono::milliseconds(0) : settings_.settling);
  if (!more.empty()) return {{}, std::move(more)};
  return {std::move(json), {}};
}

std::string NumberedProcess::said_more(std::chrono::milliseconds settling) {
  if (!asked_) return {};
  const auto text = process_.unasked(settling);
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

}  // namespace jaywalk
