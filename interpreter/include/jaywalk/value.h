// SPDX-License-Identifier: Apache-2.0
#pragma once

// Terms of the language as C++ values. A Value is a number, an atom, the empty list, or a reference
// to a string, list, structure or variable in the memory of an agent or of a program: 8 bytes, to
// be copied. Terms reads those and makes new ones.
//
// A Value that an action, a percept or another function was given is good until that function
// returns, and no longer: the memory is cleared. Keep numbers and copies of strings.
//
//   63            48 47                          3 2      1      0
//   [ kind          | address or id               | | static closed ]
//
// Numbers are doubles, as in Jason; all other kinds hide in the unused bit patterns of
// not-a-numbers. `closed` marks a list or structure without variables, slots and unevaluated
// expressions: applying a unifier to it is the identity. `static` marks cells owned by a program:
// collection leaves them.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

class Heap;
class SymbolTable;
struct ObjectCell;
struct Pair;
struct Structure;
struct Text;
struct Variable;

/// The number of a predicate in a symbol table: namespace, strong negation, functor and arity.
enum class Predicate : std::uint32_t;

/// The predicate of the default namespace with that functor and arity, entered if the table lacks
/// it; `~` before the functor means strong negation.
[[nodiscard]] Predicate predicate_named(SymbolTable& symbols, std::string_view functor,
                                        std::size_t arity);

/// One term. What is made without arguments is unset: no term at all.
class Value {
 public:
  enum class Kind : std::uint8_t {
    number,
    atom,       // a literal without arguments and annotations
    text,       // a string
    structure,  // a literal with arguments or annotations, an expression, a plan, ...
    pair,       // a list that is not empty
    variable,   // a cell that may be bound
    special,    // empty list, unset, slot
    object,     // a set, map or queue, shared by reference
  };

  constexpr Value() = default;  // unset

  [[nodiscard]] static constexpr Value number(double value) {
    // One bit pattern for all NaNs keeps the kinds apart.
    return value == value ? Value(std::bit_cast<std::uint64_t>(value)) : Value(kNan);
  }
  [[nodiscard]] static constexpr Value atom(Predicate id) {
    return Value(tag(Kind::atom) | static_cast<std::uint64_t>(id) << 3U);
  }
  [[nodiscard]] static constexpr Value empty_list() { return Value(kEmptyList); }

  [[nodiscard]] constexpr Kind kind() const {
    return bits_ < tag(Kind::atom) ? Kind::number : static_cast<Kind>((bits_ >> 48U) - 0xFFF8U);
  }
  [[nodiscard]] constexpr bool is_number() const { return bits_ < tag(Kind::atom); }
  [[nodiscard]] constexpr bool is_atom() const { return has(Kind::atom); }
  /// An atom or a structure.
  [[nodiscard]] constexpr bool is_name() const { return (bits_ >> 48U | 2U) == 0xFFFBU; }
  [[nodiscard]] constexpr bool is_text() const { return has(Kind::text); }
  [[nodiscard]] constexpr bool is_structure() const { return has(Kind::structure); }
  [[nodiscard]] constexpr bool is_pair() const { return has(Kind::pair); }
  [[nodiscard]] constexpr bool is_variable() const { return has(Kind::variable); }
  [[nodiscard]] constexpr bool is_object() const { return has(Kind::object); }
  [[nodiscard]] constexpr bool is_empty_list() const { return bits_ == kEmptyList; }
  [[nodiscard]] constexpr bool is_list() const { return is_pair() || is_empty_list(); }
  [[nodiscard]] constexpr bool is_unset() const { return bits_ == kUnset; }

  /// REQUIRES: the kind.
  [[nodiscard]] constexpr double as_number() const { return std::bit_cast<double>(bits_); }
  [[nodiscard]] constexpr Predicate atom_id() const {
    return static_cast<Predicate>((bits_ & kPayload) >> 3U);
  }

  /// The same immediate or the same cell; not equality of terms (Terms::equal).
  [[nodiscard]] constexpr bool same_as(Value other) const { return bits_ == other.bits_; }

  // What follows is for the engine, whose headers have the cells that a Value refers to.

  /// A reference to the variable that a frame holds at `index`; only in compiled programs.
  [[nodiscard]] static constexpr Value slot(std::uint32_t index) {
    return Value(kSlot | static_cast<std::uint64_t>(index) << 3U);
  }
  [[nodiscard]] constexpr bool is_slot() const { return (bits_ & kSlotMask) == kSlot; }
  [[nodiscard]] constexpr std::uint32_t slot_index() const {
    return static_cast<std::uint32_t>((bits_ & 0xFFFFFFFFFFU) >> 3U);
  }
  [[nodiscard]] Structure* structure() const { return pointer<Structure>(); }
  [[nodiscard]] Pair* pair() const { return pointer<Pair>(); }
  [[nodiscard]] Text* text() const { return pointer<Text>(); }
  [[nodiscard]] Variable* variable() const { return pointer<Variable>(); }
  [[nodiscard]] ObjectCell* object() const { return pointer<ObjectCell>(); }

  /// Whether applying a unifier to it is the identity.
  [[nodiscard]] constexpr bool is_closed() const {
    if (bits_ < tag(Kind::structure)) return true;  // by order of the kinds
    if (bits_ < tag(Kind::variable)) return (bits_ & kClosed) != 0;
    return !is_variable() && !is_slot();
  }
  [[nodiscard]] constexpr bool is_static() const { return (bits_ & kStatic) != 0; }

  [[nodiscard]] static Value reference(Kind kind, const void* cell, std::uint64_t flags) {
    return Value(tag(kind) | (reinterpret_cast<std::uintptr_t>(cell) & kAddress) | flags);
  }
  [[nodiscard]] constexpr std::uint64_t bits() const { return bits_; }
  [[nodiscard]] constexpr std::uint64_t flags() const { return bits_ & (kClosed | kStatic); }

  static constexpr std::uint64_t kClosed = 1;
  static constexpr std::uint64_t kStatic = 2;

 private:
  static constexpr std::uint64_t kPayload = 0x0000FFFFFFFFFFFFU;
  static constexpr std::uint64_t kAddress = 0x0000FFFFFFFFFFF8U;
  static constexpr std::uint64_t kNan = 0x7FF8000000000000U;
  [[nodiscard]] static constexpr std::uint64_t tag(Kind kind) {
    return (0xFFF8U + static_cast<std::uint64_t>(kind)) << 48U;
  }
  static constexpr std::uint64_t kSpecial = (0xFFF8U + static_cast<std::uint64_t>(6)) << 48U;
  static constexpr std::uint64_t kUnset = kSpecial;
  static constexpr std::uint64_t kEmptyList = kSpecial | 1U << 3U;
  static constexpr std::uint64_t kSlot = kSpecial | std::uint64_t{1} << 40U;
  static constexpr std::uint64_t kSlotMask = 0xFFFFFF0000000000U;

  explicit constexpr Value(std::uint64_t bits) : bits_(bits) {}
  [[nodiscard]] constexpr bool has(Kind kind) const {
    return (bits_ >> 48U) == 0xFFF8U + static_cast<std::uint64_t>(kind);
  }
  template <class T>
  [[nodiscard]] T* pointer() const {
    return reinterpret_cast<T*>(bits_ & kAddress);
  }

  std::uint64_t bits_ = kUnset;
};

/// Reads the terms of an agent, and makes new ones in its memory. All functions follow variables
/// that are bound: a part of a term is never one. Cheap to copy; lives as long as what it was got
/// from.
class Terms {
 public:
  Terms(Heap& heap, SymbolTable& symbols) : heap_(&heap), symbols_(&symbols) {}

  /// A bound variable's value; any other term itself.
  [[nodiscard]] Value value(Value term) const;
  /// An atom, or a structure that is not an expression, formula or plan.
  [[nodiscard]] bool is_literal(Value term) const;
  /// A literal's functor, "lane" for `~lane(2)[source(self)]`; else empty.
  [[nodiscard]] std::string_view functor(Value term) const;
  [[nodiscard]] bool is_negated(Value term) const;
  /// A literal's arguments; else none.
  [[nodiscard]] std::vector<Value> args(Value term) const;
  /// A literal's annotations, sorted; else none.
  [[nodiscard]] std::vector<Value> annotations(Value term) const;
  /// A list's elements, up to an open tail; else none.
  [[nodiscard]] std::vector<Value> elements(Value term) const;
  /// A string's content; else empty.
  [[nodiscard]] std::string_view text(Value term) const;
  /// The term as it is printed: `p(a,[1,2])`, `"text"`.
  [[nodiscard]] std::string printed(Value term) const;
  /// The same term, as `==` of the language compares. Annotations count.
  [[nodiscard]] bool equal(Value a, Value b) const;

  [[nodiscard]] Value atom(std::string_view functor) const;
  [[nodiscard]] Value string(std::string_view content) const;
  [[nodiscard]] Value list(const std::vector<Value>& elements) const;
  /// A literal; without arguments and annotations an atom. `~` before the functor negates. More
  /// than 65,535 arguments: the action that asks for it fails.
  [[nodiscard]] Value structure(std::string_view functor, const std::vector<Value>& args,
                                const std::vector<Value>& annotations = {}) const;
  /// A variable that is not bound.
  [[nodiscard]] Value variable() const;

 private:
  Heap* heap_;
  SymbolTable* symbols_;
};

}  // namespace jaywalk
