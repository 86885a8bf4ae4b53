// SPDX-License-Identifier: Apache-2.0
#pragma once

// The memory of terms. A Heap is a bump allocator with a copying collector. Each agent has one; a
// program's constants have another whose cells never move. Nothing is freed one by one: at the end
// of a reasoning cycle the agent may collect, giving all its roots, so a Value that is held in a
// local variable is good until the end of the cycle, and no longer.
//
//   Structure   [ predicate:32 arity:16 info:16 ] ([ annotations ]) [ arg 0 ] ... [ arg n-1 ]
//   Pair        [ head ] [ tail ]
//   Text        [ length:32 unused:16 kTextInfo:16 ] bytes ...
//   Variable    [ value or unset ] [ name:32 serial:32 ]
//   ObjectCell  [ kObjectInfo << 48 ] [ Object* ]

#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "interpreter/support/containers/lazy.h"
#include "interpreter/support/width.h"
#include "interpreter/term/object.h"
#include "interpreter/term/value.h"

namespace jaywalk {

/// Thrown when a structure would have more than kMostParts arguments; caught where the agent
/// executes a step.
struct TermTooWide {};

/// The kind of a structure. All but literals are made by the language itself: unevaluated
/// expressions and programs as data.
enum class Form : std::uint8_t {
  literal,
  expression,  // arithmetic not evaluated yet: `X+1`
  function,    // an arithmetic function not evaluated yet: `math.max(X,2)`
  relation,    // `X < 3`
  logical,     // `a & b`, `a | b`, `not a`
  decorated,   // a variable with annotations, negation or a namespace; args: variable[, namespace]
  body,        // a plan body; args: steps
  step,        // a body formula; the functor is its operator; args: term, line
  trigger,     // the functor is the operator, `+!`; args: literal
  plan,        // args: label, trigger, context, body, goal condition, sub-plans (a list)
  rule,        // args: head, body
};

struct Structure {
  std::uint32_t predicate_id;
  std::uint16_t arity;
  std::uint16_t info;

  static constexpr std::uint16_t kAnnotated = 0x100;
  /// Marks a plan's own trigger and body, which are printed without braces.
  static constexpr std::uint16_t kBare = 0x200;

  [[nodiscard]] Predicate predicate() const { return static_cast<Predicate>(predicate_id); }
  [[nodiscard]] Form form() const { return static_cast<Form>(info & 0xFFU); }
  [[nodiscard]] bool is_annotated() const { return (info & kAnnotated) != 0; }
  [[nodiscard]] Value* cells() { return reinterpret_cast<Value*>(this + 1); }
  [[nodiscard]] const Value* cells() const { return reinterpret_cast<const Value*>(this + 1); }
  [[nodiscard]] const Value* args() const { return cells() + (is_annotated() ? 1 : 0); }
  [[nodiscard]] Value* args() { return cells() + (is_annotated() ? 1 : 0); }
  [[nodiscard]] Value arg(std::size_t index) const { return args()[index]; }
  [[nodiscard]] std::span<const Value> arg_span() const { return {args(), arity}; }
  /// The annotations: a sorted list without duplicates, perhaps open (`[a|T]`); empty if none.
  [[nodiscard]] Value annots() const { return is_annotated() ? cells()[0] : Value::empty_list(); }
};

/// Whether a dereferenced value is a structure of that form.
[[nodiscard]] inline bool is_form(Value value, Form form) {
  return value.is_structure() && value.structure()->form() == form;
}

/// Whether a dereferenced value is something to be computed, `X + 1` or `math.abs(X)`.
[[nodiscard]] inline bool is_evaluable(Value value) {
  return is_form(value, Form::expression) || is_form(value, Form::function);
}

struct Pair {
  Value head;
  Value tail;
};

struct Text {
  std::uint32_t length;
  std::uint16_t unused;
  std::uint16_t info;
  [[nodiscard]] std::string_view view() const {
    return {reinterpret_cast<const char*>(this + 1), length};
  }
};

struct Variable {
  Value value;
  std::uint32_t name_id;
  std::uint32_t serial;
  [[nodiscard]] Symbol name() const { return static_cast<Symbol>(name_id); }
};

struct ObjectCell {
  std::uint64_t info;
  Object* object;
};

/// Dereferences: follows variables to a value or an unbound variable.
[[nodiscard]] inline Value deref(Value value) {
  while (value.is_variable()) {
    const Value next = value.variable()->value;
    if (next.is_unset()) return value;
    value = next;
  }
  return value;
}

/// Thrown when an agent's heap would exceed its limit; caught where the agent executes a step.
struct HeapExhausted {
  bool of_all = false;  // it is the agent's remainder of a limit for all agents together
};
/// Thrown when a term is nested too deeply to be walked; caught where the agent executes a step.
struct TermTooDeep {};

/// How deeply terms may be nested at run time.
inline constexpr int kMaxTermDepth = 2000;

class Heap {
 public:
  enum class Owner { agent, program };

  explicit Heap(Owner owner = Owner::agent);

  /// Memory of a heap, for one that has not been used yet.
  class Remains {
    friend class Heap;
    std::unique_ptr<std::uint64_t[]> words_;  // a first chunk, or null
    std::size_t size_ = 0;
  };
  /// Ends the heap's life.
  [[nodiscard]] Remains leave_remains();
  void use(Remains remains);
  /// Everything goes, and memory for a few new terms stays. REQUIRES: no Value of it is in use.
  void clear();
  /// Nothing has been made here yet.
  [[nodiscard]] bool is_unused() const { return chunks_.empty(); }

  // Most agents finish soon, and few of their terms survive. So an agent's heap begins in a
  // borrowed nursery, and later moves out into a chunk of just the size of its live terms.
  /// Begins in the nursery, which is made if there is none. REQUIRES: is_unused().
  void enter(Remains& nursery);
  /// Leaves the nursery; nothing happens if the heap has grown out of it. While it is found out how
  /// much is alive, that stands in `aside`.
  template <class VisitRoots>
  void leave(Remains& nursery, Remains& aside, VisitRoots&& visit_roots) {
    if (chunks_.size() != 1 || chunks_.front().size != kNurseryWords) return;
    if (aside.words_ == nullptr) aside = chunk_of(kNurseryWords);
    nursery = collect_into(std::move(aside), visit_roots);
    aside = collect_into(chunk_of(bytes() / sizeof(std::uint64_t)), visit_roots);
  }

  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  /// Values of all kinds. The flag `closed` is derived from the parts.
  [[nodiscard]] Value structure(Predicate predicate, std::span<const Value> args,
                                Value annots = Value::empty_list(), Form form = Form::literal);
  /// A literal whose arguments the caller fills in at once; annotations are closed. `literal_of`
  /// makes a Value of it, and passes whether all arguments are closed.
  [[nodiscard]] Structure* blank_literal(Predicate predicate, std::size_t arity, Value annots) {
    auto* const made = reinterpret_cast<Structure*>(allocate(2 + arity));
    made->predicate_id = static_cast<std::uint32_t>(predicate);
    made->arity = static_cast<std::uint16_t>(arity);
    made->info = static_cast<std::uint16_t>(Form::literal) | Structure::kAnnotated;
    made->cells()[0] = annots;
    return made;
  }
  [[nodiscard]] Value literal_of(const Structure* made, bool closed) const {
    return Value::reference(Value::Kind::structure, made,
                            (closed ? Value::kClosed : 0) | static_flag_);
  }
  [[nodiscard]] [[gnu::always_inline]] Value pair(Value head, Value tail) {
    auto* const made = reinterpret_cast<Pair*>(allocate(2));
    made->head = head;
    made->tail = tail;
    const bool closed = head.is_closed() && tail.is_closed();
    return Value::reference(Value::Kind::pair, made, (closed ? Value::kClosed : 0) | static_flag_);
  }
  /// A pair whose tail is a fresh variable, which `tail` receives.
  [[nodiscard]] [[gnu::always_inline]] Value pair_before(Value& tail, Value head, Symbol name) {
    std::uint64_t* const words = allocate(4);
    auto* const variable = reinterpret_cast<Variable*>(words);
    variable->value = Value();
    variable->name_id = static_cast<std::uint32_t>(name);
    variable->serial = static_cast<std::uint32_t>(next_serial_++);
    auto* const made = reinterpret_cast<Pair*>(words + 2);
    tail = Value::reference(Value::Kind::variable, variable, 0);
    made->head = head;
    made->tail = tail;
    return Value::reference(Value::Kind::pair, made, static_flag_);
  }
  [[nodiscard]] Value list(std::span<const Value> elements, Value tail = Value::empty_list());
  [[nodiscard]] Value text(std::string_view bytes);
  [[nodiscard]] [[gnu::always_inline]] Value variable(Symbol name = names::unnamed) {
    auto* const made = reinterpret_cast<Variable*>(allocate(2));
    made->value = Value();
    made->name_id = static_cast<std::uint32_t>(name);
    made->serial = static_cast<std::uint32_t>(next_serial_++);
    return Value::reference(Value::Kind::variable, made, 0);
  }
  [[nodiscard]] Value object(std::unique_ptr<Object> object);
  /// Variables with this serial or a greater one are made from now on; after four thousand million
  /// variables none is known to be.
  [[nodiscard]] std::uint32_t first_young() const {
    constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
    return next_serial_ < kNone ? static_cast<std::uint32_t>(next_serial_) : kNone;
  }

  /// A place to which the heap can be cut back when nothing made since is needed.
  struct Mark {
    std::size_t chunk = 0;
    std::uint64_t* top = nullptr;
  };
  [[nodiscard]] Mark mark() const { return {chunks_.size(), top_}; }
  void release(Mark mark) {
    const bool is_below_floor =
        mark.chunk < floor_.chunk || (mark.chunk == floor_.chunk && mark.top < floor_.top);
    if (is_below_floor) mark = floor_;
    if (chunks_.size() > mark.chunk) release_chunks(mark.chunk);
    top_ = mark.top;
  }
  /// Nothing allocated until now is released any more, whatever the mark.
  void protect() { floor_ = mark(); }

  [[nodiscard]] std::size_t bytes() const { return full_bytes_ + used_in_current(); }
  /// The size of all collections, without the terms in them.
  [[nodiscard]] std::size_t object_bytes() const;

  // Sets the limit for all memory of the owner: its terms, counted twice, since a collection needs
  // the old and the new ones at once, and its other memory, which the owner notes at each
  // allocation and recounts now and then.
  void set_limit(std::size_t bytes) {
    if (bytes < limit_bytes_) look_sooner(bytes);
    limit_bytes_ = bytes;
  }
  /// The limit is what others leave of one for all together.
  void set_limit_of_all(bool of_all) { limit_is_of_all_ = of_all; }
  [[nodiscard]] std::size_t limit() const { return limit_bytes_; }
  [[nodiscard]] std::size_t other_bytes() const { return other_bytes_; }
  [[nodiscard]] std::size_t all_bytes() const { return 2 * bytes() + other_bytes_; }
  /// The owner has got something that is no term.
  void note_other_bytes(std::size_t bytes) { other_bytes_ += bytes; }
  /// Before the owner gets something that is no term. Throws HeapExhausted at the limit.
  void require_room() {
    if (other_bytes_ > ask_at_) require_bytes(0);
  }
  /// Like require_room(), before the owner gets `bytes` bytes.
  void require_bytes(std::size_t bytes);
  /// Sets the bytes that the owner has beside terms.
  void set_other_bytes(std::size_t bytes);
  /// Something has failed for want of memory lately, and what there is has not been counted since.
  [[nodiscard]] bool is_short() const { return full_at_ != 0; }
  /// Requests a collection and a count, however little was allocated.
  void look_again() { collect_at_ = count_at_ = ask_at_ = 0; }
  /// Enough was noted since the last count to need another.
  [[nodiscard]] bool wants_count() const { return other_bytes_ > count_at_; }
  /// Enough has been allocated since the last collection to make another worth while.
  [[nodiscard]] bool wants_collection() const { return bytes() > collect_at_; }

  /// Moves reachable terms into fresh chunks and frees the rest. `visit_roots` is called with a
  /// Relocator and must pass every Value that must survive to it.
  class Relocator {
   public:
    void operator()(Value& value);

   private:
    friend class Heap;
    explicit Relocator(Heap& heap) : heap_(heap) {}
    void move(Value& value);
    void drain();
    Heap& heap_;
    std::vector<std::pair<Value*, std::size_t>> pending_;
    std::vector<Object*> pending_objects_;
  };
  template <class VisitRoots>
  void collect(VisitRoots&& visit_roots) {
    (void)collect_into({}, visit_roots);
  }

 private:
  static constexpr std::size_t kNurseryWords = 512;
  struct Chunk {
    std::unique_ptr<std::uint64_t[]> words;
    std::size_t size = 0;
  };

  /// Moves live terms into new chunks, of which `first` is the first. Returns the first of the old
  /// chunks for reuse.
  template <class VisitRoots>
  Remains collect_into(Remains first, VisitRoots& visit_roots) {
    const std::size_t limit = limit_bytes_;
    limit_bytes_ = std::size_t(-1);  // live terms fit: they were there before
    std::vector<Chunk> old = start_collection();
    use(std::move(first));
    Relocator relocate(*this);
    visit_roots(relocate);
    relocate.drain();
    limit_bytes_ = limit;
    finish_collection();
    Remains left;
    if (!old.empty()) {
      left.words_ = std::move(old.front().words);
      left.size_ = old.front().size;
    }
    return left;
  }
  [[nodiscard]] static Remains chunk_of(std::size_t words);

  [[nodiscard]] std::uint64_t* allocate(std::size_t words) {
    if (static_cast<std::size_t>(end_ - top_) < words) grow(words);
    std::uint64_t* const cell = top_;
    top_ += words;
    return cell;
  }
  void grow(std::size_t words);
  void release_chunks(std::size_t kept);
  [[nodiscard]] std::size_t used_in_current() const {
    return static_cast<std::size_t>(top_ - start_) * sizeof(std::uint64_t);
  }
  [[nodiscard]] std::vector<Chunk> start_collection();
  void finish_collection();
  [[nodiscard]] std::size_t most_bytes() const;
  [[noreturn]] void give_up();
  void look_sooner(std::size_t limit);

  std::uint64_t* start_ = nullptr;  // of the current chunk, the last
  std::uint64_t* top_ = nullptr;
  std::uint64_t* end_ = nullptr;
  std::vector<Chunk> chunks_;
  std::size_t full_bytes_ = 0;
  Mark floor_;
  std::size_t limit_bytes_ = std::size_t{1} << 30U;
  std::size_t collect_at_ = 64 * 1024;
  std::size_t live_bytes_ = 0;  // after the last collection
  std::size_t other_bytes_ = 0;
  std::size_t count_at_ = 16 * 1024;
  std::size_t ask_at_ = count_at_;  // beyond it the limit may be reached
  // The failures for want of memory after which memory is counted again.
  std::uint32_t failures_ = 0;
  std::uint32_t patience_ = 1;
  bool limit_is_of_all_ = false;
  std::size_t full_at_ = 0;  // what there was then; 0: there was no failure
  std::uint64_t static_flag_ = 0;
  std::uint64_t next_serial_ = 1;
  std::uint64_t next_object_ = 1;
  LazyContainer<std::vector<std::unique_ptr<Object>>> objects_;
};

/// The one-element list [source(self)], [source(percept)]; made once, never moved.
[[nodiscard]] Value source_self();
[[nodiscard]] Value source_percept();

}  // namespace jaywalk
