// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a project wants an agent to reason: the options of `.mas2j` that have a meaning here.

#include <cstdint>

namespace jaywalk {

struct ReasoningSettings {
  /// `events`: whether an external event without a plan, or the event of a belief whose plan has
  /// failed, is discarded or queued again.
  enum class Unwanted : std::uint8_t { discard, requeue };
  Unwanted unwanted = Unwanted::discard;
  /// `intBels = sameFocus`: the plan for `+b` runs before the next formula; else on its own.
  bool same_focus = true;
  /// `nrcbp`: reasoning cycles between two looks at the world and into the inbox.
  std::uint32_t cycles_per_look = 1;
  /// `verbose`: 0: only warnings are logged, and `.print` writes plain text; 1; 2: everything.
  int verbosity = 1;
  /// `tro`: a means whose last formula calls the same goal again gives way to the new one.
  bool tail_recursion = true;
  /// `synchronised`: messages are always handled by plans.
  bool messages_by_plans = false;
};

}  // namespace jaywalk
