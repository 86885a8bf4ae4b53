// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/symbol.h"

#include <array>

namespace jaywalk {
namespace {

constexpr std::array kSymbolTexts{
#define JAYWALK_SYMBOL(id, text) std::string_view(text),
#include "interpreter/term/names.def"
};

struct NamedPredicate {
  Symbol functor;
  std::uint16_t arity;
};

// Not 0, and different in its first bits.
std::uint32_t spread(std::uint64_t key) {
  return static_cast<std::uint32_t>((key ^ key >> 29U) * 0x9E3779B97F4A7C15U >> 32U) | 1U;
}

std::uint32_t hash_of(std::string_view text) { return spread(std::hash<std::string_view>{}(text)); }

std::uint32_t hash_of(const Signature& signature) {
  std::uint64_t key = static_cast<std::uint64_t>(signature.functor) << 32U |
                      static_cast<std::uint64_t>(signature.ns);
  key ^= static_cast<std::uint64_t>(signature.arity) << 20U ^
         static_cast<std::uint64_t>(signature.negated ? 1 : 0) << 19U;
  return spread(key * 0x9E3779B97F4A7C15U);
}

constexpr std::array kPredicates{
#define JAYWALK_PREDICATE(id, functor, arity) NamedPredicate{names::functor, arity},
#include "interpreter/term/names.def"
};

}  // namespace

bool is_dotted(std::string_view functor) {
  return !functor.starts_with('\'') && functor.find('.') != functor.npos;
}

SymbolTable::SymbolTable() {
  for (const std::string_view text : kSymbolTexts) symbol(text);
  for (const NamedPredicate& named : kPredicates) {
    predicate(Signature{.functor = named.functor, .arity = named.arity});
  }
}

SymbolTable::SymbolTable(std::shared_ptr<const SymbolTable> base)
    : base_(std::move(base)),
      first_symbol_(static_cast<std::uint32_t>(base_->symbol_count())),
      first_predicate_(static_cast<std::uint32_t>(base_->predicate_count())) {}

void SymbolTable::clear_layer() {
  symbols_.clear();
  predicates_.clear();
  names_.clear();
  signatures_.clear();
  ++times_cleared_;
}

bool SymbolTable::knows(std::string_view text) const {
  return find(text, hash_of(text)).has_value();
}

std::optional<Symbol> SymbolTable::find_here(std::string_view text, std::uint32_t hash) const {
  const std::int64_t place = symbols_.find(hash, [&](std::int64_t candidate) {
    return names_[static_cast<std::size_t>(candidate)].text == text;
  });
  if (place == HashIndex::kNone) return std::nullopt;
  return Symbol{first_symbol_ + static_cast<std::uint32_t>(place)};
}

std::optional<Symbol> SymbolTable::find(std::string_view text, std::uint32_t hash) const {
  if (base_ != nullptr) {
    if (const auto known = base_->find(text, hash)) return known;
  }
  const auto guard = lock<ReadingLock>();
  return find_here(text, hash);
}

std::optional<Predicate> SymbolTable::find_here(const Signature& signature,
                                                std::uint32_t hash) const {
  const std::int64_t place = predicates_.find(hash, [&](std::int64_t candidate) {
    return signatures_[static_cast<std::size_t>(candidate)].signature == signature;
  });
  if (place == HashIndex::kNone) return std::nullopt;
  return signatures_[static_cast<std::size_t>(place)].predicate;
}

std::optional<Predicate> SymbolTable::find(const Signature& signature, std::uint32_t hash) const {
  if (base_ != nullptr) {
    if (const auto known = base_->find(signature, hash)) return known;
  }
  const auto guard = lock<ReadingLock>();
  return find_here(signature, hash);
}

Symbol SymbolTable::symbol(std::string_view text) {
  const std::uint32_t hash = hash_of(text);
  if (const auto known = find(text, hash)) return *known;
  const auto guard = lock<WritingLock>();
  if (has_threads_) {  // another one may have been faster
    if (const auto known = find_here(text, hash)) return *known;
  }
  const Symbol id{static_cast<std::uint32_t>(symbol_count())};
  symbols_.add(hash, static_cast<std::int64_t>(names_.size()));
  names_.push_back({std::string(text), is_dotted(text)});
  return id;
}

Predicate SymbolTable::predicate(const Signature& signature) {
  Signature complete = signature;
  const Name& functor = name(signature.functor);
  complete.dotted = functor.is_dotted;
  const std::uint32_t hash = hash_of(complete);
  if (const auto known = find(complete, hash)) return *known;
  const auto guard = lock<WritingLock>();
  if (has_threads_) {
    if (const auto known = find_here(complete, hash)) return *known;
  }
  // The name of a file's own namespace is as hidden as what is in it.
  const bool is_hidden =
      signature.ns != names::default_ns || functor.text.starts_with(kLocalNamespace);
  const Predicate id{static_cast<std::uint32_t>(predicate_count()) | (is_hidden ? kForeignBit : 0) |
                     (signature.negated ? kNegatedBit : 0)};
  predicates_.add(hash, static_cast<std::int64_t>(signatures_.size()));
  signatures_.push_back({complete, id});
  return id;
}

Predicate SymbolTable::predicate(std::string_view functor, std::uint16_t arity) {
  const bool negated = functor.starts_with('~');
  if (negated) functor.remove_prefix(1);
  return predicate(Signature{.functor = symbol(functor), .arity = arity, .negated = negated});
}

std::string_view SymbolTable::text(Symbol symbol) const { return name(symbol).text; }

const SymbolTable::Name& SymbolTable::name(Symbol symbol) const {
  const SymbolTable* table = this;
  while (static_cast<std::uint32_t>(symbol) < table->first_symbol_) table = table->base_.get();
  const auto guard = table->lock<ReadingLock>();
  return table->names_[static_cast<std::uint32_t>(symbol) - table->first_symbol_];
}

const Signature& SymbolTable::signature(Predicate predicate) const {
  const std::uint32_t index = static_cast<std::uint32_t>(predicate) & ~(kForeignBit | kNegatedBit);
  const SymbolTable* table = this;
  while (index < table->first_predicate_) table = table->base_.get();
  const auto guard = table->lock<ReadingLock>();
  return table->signatures_[index - table->first_predicate_].signature;
}

std::string_view SymbolTable::functor(Predicate predicate) const {
  return text(signature(predicate).functor);
}

}  // namespace jaywalk
