// SPDX-License-Identifier: Apache-2.0
#pragma once

// Messages between agents. Names are numbers as far as they can be: texts are made where a plan
// sees them.

#include <cstdint>
#include <string>
#include <string_view>

#include "interpreter/term/symbol.h"
#include "interpreter/term/value.h"

namespace jaywalk {

/// The name of an agent's own message, "mid7", or of a question whose answers it waits for,
/// "samid7".
struct MessageId {
  enum class Kind : std::uint8_t { none, message, question };

  Kind kind = Kind::none;
  std::uint32_t number = 0;

  friend bool operator==(const MessageId&, const MessageId&) = default;
};

/// "" for none.
[[nodiscard]] std::string text_of(MessageId id);
/// The question that a message says it answers; none if it names no question. The name of a
/// question that no agent can have asked, "samid007", is a question with number 0.
[[nodiscard]] MessageId question_named(std::string_view text);

struct Message {
  std::string_view sender;  // "self" if it is from the agent itself; lives as long as the run
  Predicate sender_atom{};  // the same as an atom
  Symbol performative{};
  Value content;
  MessageId id;
  MessageId in_reply_to;
};

}  // namespace jaywalk
