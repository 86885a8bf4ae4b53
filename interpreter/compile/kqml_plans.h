// SPDX-License-Identifier: Apache-2.0
#pragma once

// The plans with which every agent handles messages, unless its own plans for
// `kqml_received(Sender, Performative, Content, MessageId)` come first. In AgentSpeak.

#include <string_view>

namespace jaywalk {

extern const std::string_view kKqmlPlans;

}  // namespace jaywalk
