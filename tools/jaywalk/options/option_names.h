// SPDX-License-Identifier: Apache-2.0
#pragma once

// The name of every option of the command line, each once: commands declare, read and report
// options by these constants. A text is no OptionName, so that a misspelt one does not compile.

#include "tools/jaywalk/options/arguments.h"

namespace jaywalk::option {

inline constexpr OptionName kAgent{"agent"};
inline constexpr OptionName kAgents{"agents"};
inline constexpr OptionName kAll{"all"};
inline constexpr OptionName kAllowCommands{"allow-commands"};
inline constexpr OptionName kAllowRead{"allow-read"};
inline constexpr OptionName kAllowWrite{"allow-write"};
inline constexpr OptionName kAssertions{"assertions"};
inline constexpr OptionName kAvs{"avs"};
inline constexpr OptionName kBehaviour{"behaviour"};
inline constexpr OptionName kBehaviours{"behaviours"};
inline constexpr OptionName kCheck{"check"};
inline constexpr OptionName kColor{"color"};
inline constexpr OptionName kConnection{"connection"};
inline constexpr OptionName kCoverage{"coverage"};
inline constexpr OptionName kCsv{"csv"};
inline constexpr OptionName kDefect{"defect"};
inline constexpr OptionName kDefects{"defects"};
inline constexpr OptionName kDialect{"dialect"};
inline constexpr OptionName kDumpCode{"dump-code"};
inline constexpr OptionName kEnvironment{"environment"};
inline constexpr OptionName kEnvironmentTimeout{"environment-timeout"};
inline constexpr OptionName kExport{"export"};
inline constexpr OptionName kFailOn{"fail-on"};
inline constexpr OptionName kFilter{"filter"};
inline constexpr OptionName kFormat{"format"};
inline constexpr OptionName kGenerators{"generators"};
inline constexpr OptionName kGif{"gif"};
inline constexpr OptionName kHelp{"help"};
inline constexpr OptionName kHtml{"html"};
inline constexpr OptionName kIgnoreJava{"ignore-java"};
inline constexpr OptionName kInclude{"include"};
inline constexpr OptionName kJason{"jason"};
inline constexpr OptionName kJson{"json"};
inline constexpr OptionName kJunit{"junit"};
inline constexpr OptionName kKills{"kills"};
inline constexpr OptionName kLearner{"learner"};
inline constexpr OptionName kList{"list"};
inline constexpr OptionName kLogLevel{"log-level"};
inline constexpr OptionName kMap{"map"};
inline constexpr OptionName kMaxCycles{"max-cycles"};
inline constexpr OptionName kMaxInferences{"max-inferences"};
inline constexpr OptionName kMaxMemory{"max-memory"};
inline constexpr OptionName kMaxTicks{"max-ticks"};
inline constexpr OptionName kMetrics{"metrics"};
inline constexpr OptionName kMostStates{"most-states"};
inline constexpr OptionName kNoCheck{"no-check"};
inline constexpr OptionName kOut{"out"};
inline constexpr OptionName kOverwrite{"overwrite"};
inline constexpr OptionName kPerTest{"per-test"};
inline constexpr OptionName kPng{"png"};
inline constexpr OptionName kPolicy{"policy"};
inline constexpr OptionName kPreset{"preset"};
inline constexpr OptionName kQuiet{"quiet"};
inline constexpr OptionName kRealtime{"realtime"};
inline constexpr OptionName kRepetitions{"repetitions"};
inline constexpr OptionName kReplays{"replays"};
inline constexpr OptionName kReport{"report"};
inline constexpr OptionName kResume{"resume"};
inline constexpr OptionName kRetryErrors{"retry-errors"};
inline constexpr OptionName kScenario{"scenario"};
inline constexpr OptionName kSchema{"schema"};
inline constexpr OptionName kSeed{"seed"};
inline constexpr OptionName kSet{"set"};
inline constexpr OptionName kShard{"shard"};
inline constexpr OptionName kSituations{"situations"};
inline constexpr OptionName kSpeed{"speed"};
inline constexpr OptionName kStarts{"starts"};
inline constexpr OptionName kStdio{"stdio"};
inline constexpr OptionName kStore{"store"};
inline constexpr OptionName kStoreLevel{"store-level"};
inline constexpr OptionName kStrict{"strict"};
inline constexpr OptionName kTest{"test"};
inline constexpr OptionName kTests{"tests"};
inline constexpr OptionName kThreads{"threads"};
inline constexpr OptionName kTick{"tick"};
inline constexpr OptionName kTimeout{"timeout"};
inline constexpr OptionName kTrace{"trace"};
inline constexpr OptionName kTry{"try"};
inline constexpr OptionName kWatch{"watch"};
inline constexpr OptionName kWerror{"werror"};
inline constexpr OptionName kWithKills{"with-kills"};
inline constexpr OptionName kWrite{"write"};

}  // namespace jaywalk::option
