// SPDX-License-Identifier: Apache-2.0
#pragma once

// The plans added to a program under test: the assertion goals of Jason's framework, mock agents,
// and the goal that runs the test. They are AgentSpeak, and leave their findings in beliefs of the
// namespace jaywalk_test:
//
//   result(Number, Assertion, Verdict, Line, File, Expected, Actual)   Verdict: passed or failed
//   finished                                                           the test's goal is achieved
//   broken(Error, Message, Code, Line, File)                           ... has failed

#include <string_view>

namespace jaywalk {

inline constexpr std::string_view kTestNamespace = "jaywalk_test";

/// Plans and rules for every program under test.
[[nodiscard]] std::string_view assertion_goals();

/// The program of `.create_agent(Name, "mock_agent.asl")`.
[[nodiscard]] std::string_view mock_agent();

}  // namespace jaywalk
