// SPDX-License-Identifier: Apache-2.0
#pragma once

// Interned names. A Symbol is a text; a Predicate is what Jason calls a predicate indicator:
// namespace, strong negation, functor and arity. `~p/1` and `n::p/1` are predicates of their own.
// Ids are dense and depend on the order of interning: nothing that the user sees may depend on
// them; order by text instead.

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/containers/hash_index.h"

namespace jaywalk {

enum class Symbol : std::uint32_t {};
enum class Predicate : std::uint32_t {};

/// How the names of namespaces that a file has for itself begin.
inline constexpr char kLocalNamespace = '#';

/// Predicates outside the default namespace, and the names of local namespaces, have this bit:
/// plain variables do not take them.
inline constexpr std::uint32_t kForeignBit = 0x8000'0000U;
[[nodiscard]] constexpr bool is_foreign(Predicate predicate) {
  return (static_cast<std::uint32_t>(predicate) & kForeignBit) != 0;
}
/// Predicates with strong negation have this one.
inline constexpr std::uint32_t kNegatedBit = 0x4000'0000U;
[[nodiscard]] constexpr bool is_negated(Predicate predicate) {
  return (static_cast<std::uint32_t>(predicate) & kNegatedBit) != 0;
}

/// The names that the engine itself needs; every table has them under these ids.
namespace names {
enum class SymbolIndex : std::uint32_t {
#define JAYWALK_SYMBOL(id, text) id,
#include "interpreter/term/names.def"
};
#define JAYWALK_SYMBOL(id, text) \
  inline constexpr Symbol id{static_cast<std::uint32_t>(SymbolIndex::id)};
#include "interpreter/term/names.def"
}  // namespace names

namespace predicates {
enum class PredicateIndex : std::uint32_t {
#define JAYWALK_PREDICATE(id, functor, arity) id,
#include "interpreter/term/names.def"
};
#define JAYWALK_PREDICATE(id, functor, arity) \
  inline constexpr Predicate id{static_cast<std::uint32_t>(PredicateIndex::id)};
#include "interpreter/term/names.def"
}  // namespace predicates

struct Signature {
  Symbol ns = names::default_ns;
  Symbol functor = names::empty;
  std::uint16_t arity = 0;
  bool negated = false;
  /// The functor contains a dot: an internal action or a function. Derived from the functor.
  bool dotted = false;

  friend bool operator==(const Signature&, const Signature&) = default;
};

/// Whether a functor names an internal action, `.print`; not if it is quoted.
[[nodiscard]] bool is_dotted(std::string_view functor);

/// Interns texts and signatures. A table may extend another, frozen one: programs that are shared
/// by many runs are compiled into one base table; each run adds its own names in a layer above it,
/// so that runs on several threads never write to shared memory. Where one run has several threads,
/// its layer is guarded by a lock; names of the base are found without it.
class SymbolTable {
 public:
  SymbolTable();
  /// A layer above `base`, which must not change any more.
  explicit SymbolTable(std::shared_ptr<const SymbolTable> base);
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  /// From now on several threads may use the table at once.
  void allow_threads() { has_threads_ = true; }

  /// Forgets the names above the base. REQUIRES: nothing refers to them any more.
  void clear_layer();
  /// How often that was done: what is known of a predicate's number holds until the next time.
  [[nodiscard]] std::uint32_t times_cleared() const { return times_cleared_; }

  Symbol symbol(std::string_view text);
  Predicate predicate(const Signature& signature);
  /// A predicate of the default namespace; `~` before the functor means strong negation.
  Predicate predicate(std::string_view functor, std::uint16_t arity);

  /// Whether some name is this text.
  [[nodiscard]] bool knows(std::string_view text) const;
  [[nodiscard]] std::string_view text(Symbol symbol) const;
  [[nodiscard]] const Signature& signature(Predicate predicate) const;
  [[nodiscard]] std::string_view functor(Predicate predicate) const;
  [[nodiscard]] std::size_t symbol_count() const { return first_symbol_ + names_.size(); }
  [[nodiscard]] std::size_t predicate_count() const {
    return first_predicate_ + signatures_.size();
  }

 private:
  [[nodiscard]] std::optional<Symbol> find(std::string_view text, std::uint32_t hash) const;
  [[nodiscard]] std::optional<Symbol> find_here(std::string_view text, std::uint32_t hash) const;
  [[nodiscard]] std::optional<Predicate> find(const Signature& signature, std::uint32_t hash) const;
  [[nodiscard]] std::optional<Predicate> find_here(const Signature& signature,
                                                   std::uint32_t hash) const;
  using ReadingLock = std::shared_lock<std::shared_mutex>;
  using WritingLock = std::unique_lock<std::shared_mutex>;
  template <class Lock>
  [[nodiscard]] Lock lock() const {
    return has_threads_ ? Lock(mutex_) : Lock();
  }

  std::shared_ptr<const SymbolTable> base_;
  std::uint32_t first_symbol_ = 0;
  std::uint32_t first_predicate_ = 0;
  struct Name {
    std::string text;
    bool is_dotted = false;
  };

  [[nodiscard]] const Name& name(Symbol symbol) const;
  struct Known {
    Signature signature;
    Predicate predicate{};
  };

  // Deques, since they are referred to.
  std::deque<Name> names_;
  std::deque<Known> signatures_;
  HashIndex symbols_{0};     // by text
  HashIndex predicates_{0};  // by signature
  bool has_threads_ = false;
  std::uint32_t times_cleared_ = 0;
  mutable std::shared_mutex mutex_;
};

}  // namespace jaywalk
