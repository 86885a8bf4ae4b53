// SPDX-License-Identifier: Apache-2.0
#pragma once

// Customises agents by the functions that Jason lets an agent class override: they choose events,
// plans and intentions, revise beliefs and accept messages. Each is optional; one that is not set
// costs nothing, and the agent behaves by default.
//
// They are called between the steps of the reasoning cycle, on the thread that runs the system.
// Their arguments are valid until they return. A choice should depend on these alone (and on
// AgentView::random), so that a run can be repeated.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <jaywalk/value.h>

namespace jaywalk {

class Agent;
class BeliefRevision;

/// An agent that reasons.
class AgentView {
 public:
  explicit AgentView(Agent& agent) : agent_(&agent) {}

  [[nodiscard]] const std::string& name() const;
  /// Reads and makes its terms.
  [[nodiscard]] Terms terms() const;
  /// The next number of its own random stream, in [0, 1).
  [[nodiscard]] double random();

 private:
  Agent* agent_;
};

struct EventView {
  enum class Kind : std::uint8_t { belief, achievement_goal, test_goal };
  enum class Change : std::uint8_t { added, removed, state };  // +, -, ^

  Kind kind = Kind::belief;
  Change change = Change::added;
  Value literal;
  /// An intention waits for it; else it starts one.
  bool is_internal = false;
};

/// A plan that is applicable to an event; one with the annotation `all_unifs` is an option for each
/// solution of its context.
struct OptionView {
  /// A literal with the label's annotations; unset if the plan has no label.
  Value label;
  /// The value of each of the plan's variables; unset: it has none yet.
  std::span<const Value> values;
};

struct IntentionView {
  /// Intentions that are made later have greater ones.
  std::uint32_t number = 0;
  /// The label of the plan that it executes, as OptionView has it.
  Value label;
};

struct MessageView {
  std::string_view sender;        // "self" if it is from the agent itself
  std::string_view performative;  // "tell", "achieve", ...
  Value content;
};

/// A change of belief that an agent is about to make.
class Revision {
 public:
  explicit Revision(BeliefRevision& revision) : revision_(&revision) {}

  [[nodiscard]] AgentView agent() const;
  /// It is an addition; else a removal.
  [[nodiscard]] bool is_addition() const;
  /// The belief with its source; of a removal perhaps a pattern with variables.
  [[nodiscard]] Value literal() const;

  /// Makes the change as it was asked for. False: it changed nothing.
  bool accept();
  /// A change besides the requested one, or instead; each is an event of its own. REQUIRES: a
  /// literal.
  bool add(Value literal);
  bool remove(Value literal);

 private:
  BeliefRevision* revision_;
};

/// Functions for any number of agents. A selection is a place in what there is to choose from, less
/// than its size; nothing: none in this cycle. While an atomic intention exists, neither events nor
/// intentions are selected.
struct AgentClass {
  template <class Element>
  using Selection =
      std::function<std::optional<std::size_t>(AgentView agent, std::span<const Element> elements)>;

  /// SelEv: the event to be handled in this cycle, the oldest first.
  Selection<EventView> select_event;
  /// SelAppl: the option to intend, of at least one, in the order of the plans; nothing: the event
  /// is handled as if no plan were applicable. With it, the contexts of all relevant plans are
  /// solved, not only up to the first that holds.
  std::function<std::optional<std::size_t>(AgentView agent, const EventView& event,
                                           std::span<const OptionView> options)>
      select_option;
  /// SelInt: which intention executes its next formula, of at least one.
  Selection<IntentionView> select_intention;
  /// Belief revision, Jason's brf: accepts or changes each addition or removal of a belief, but for
  /// percepts. A change that it does not accept is not made.
  std::function<void(Revision& revision)> revise_beliefs;
  /// Social acceptance, Jason's socAcc: whether to process a message. Answers to questions of the
  /// agent's own are always accepted.
  std::function<bool(AgentView agent, const MessageView& message)> accepts_message;
};

}  // namespace jaywalk
