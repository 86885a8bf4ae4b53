#pragma once

// The engine's terms: 8 bytes each. A Value is a number, an atom, the empty list, or a reference
// to a cell in a Heap (heap.h) or in the constants of a Program. Numbers are doubles, as in Jason;
// all other kinds hide in the unused bit patterns of not-a-numbers:
//
//   63            48 47                          3 2      1      0
//   [ kind          | address or id               | | static closed ]
//
// `closed` marks a list or structure without variables, slots and unevaluated expressions: applying
// a unifier to it is the identity. `static` marks cells owned by a program: collection leaves them.

#include <bit>
#include <cstdint>
#include <limits>

#include "interpreter/term/symbol.h"

namespace jaywalk {

struct Structure;
struct Pair;
struct Text;
struct Variable;
struct ObjectCell;

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
  /// A reference to the variable that a frame holds at `index`; only in compiled programs.
  [[nodiscard]] static constexpr Value slot(std::uint32_t index) {
    return Value(kSlot | static_cast<std::uint64_t>(index) << 3U);
  }

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
  [[nodiscard]] constexpr bool is_slot() const { return (bits_ & kSlotMask) == kSlot; }

  /// REQUIRES: the kind.
  [[nodiscard]] constexpr double as_number() const { return std::bit_cast<double>(bits_); }
  [[nodiscard]] constexpr Predicate atom_id() const {
    return static_cast<Predicate>((bits_ & kPayload) >> 3U);
  }
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

  /// The same immediate or the same cell; not equality of terms (see compare.h).
  [[nodiscard]] constexpr bool same_as(Value other) const { return bits_ == other.bits_; }

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

/// Two values that cannot be unified: a number and another one, an atom and another one, a number
/// and an atom. REQUIRES: dereferenced. Of others it is not known.
[[nodiscard]] constexpr bool evidently_differ(Value a, Value b) {
  if (a.same_as(b)) return false;
  if (a.is_number() && b.is_number()) return a.as_number() != b.as_number();
  return (a.is_number() || a.is_atom()) && (b.is_number() || b.is_atom());
}

static_assert(sizeof(Value) == 8);
static_assert((static_cast<unsigned>(Value::Kind::atom) | 2U) == 3U &&
              static_cast<unsigned>(Value::Kind::structure) == 3U);  // is_name

}  // namespace jaywalk
