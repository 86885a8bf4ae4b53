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

constexpr std::array kPredicates{
#define JAYWALK_PREDICATE(id, functor, arity) NamedPredicate{names::functor, arity},
#include "interpreter/term/names.def"
};

}  // namespace

bool is_dotted(std::string_view functor) {
  return !functor.starts_with('\'') && functor.find('.') != functor.npos;
}

std::size_t SymbolTable::SignatureHash::operator()(const Signature& signature) const {
  std::uint64_t key = static_cast<std::uint64_t>(signature.functor) << 32U |
                      static_cast<std::uint64_t>(signature.ns);
  key ^= static_cast<std::uint64_t>(signature.arity) << 20U ^
         static_cast<std::uint64_t>(signature.negated ? 1 : 0) << 19U;
  key *= 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(key ^ key >> 29U);
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

const Symbol* SymbolTable::find(std::string_view text) const {
  if (base_ != nullptr) {
    if (const Symbol* const known = base_->find(text)) return known;
  }
  const auto guard = lock<ReadingLock>();
  const auto found = symbols_.find(text);
  return found == symbols_.end() ? nullptr : &found->second;
}

const Predicate* SymbolTable::find(const Signature& signature) const {
  if (base_ != nullptr) {
    if (const Predicate* const known = base_->find(signature)) return known;
  }
  const auto guard = lock<ReadingLock>();
  const auto found = predicates_.find(signature);
  return found == predicates_.end() ? nullptr : &found->second;
}

Symbol SymbolTable::symbol(std::string_view text) {
  if (const Symbol* known = find(text)) return *known;
  const auto guard = lock<WritingLock>();
  if (has_threads_) {  // another one may have been faster
    if (const auto found = symbols_.find(text); found != symbols_.end()) return found->second;
  }
  const Symbol id{static_cast<std::uint32_t>(symbol_count())};
  names_.push_back({std::string(text), is_dotted(text)});
  symbols_.emplace(names_.back().text, id);
  return id;
}

Predicate SymbolTable::predicate(const Signature& signature) {
  Signature complete = signature;
  const Name& functor = name(signature.functor);
  complete.dotted = functor.is_dotted;
  if (const Predicate* known = find(complete)) return *known;
  const auto guard = lock<WritingLock>();
  if (has_threads_) {
    const auto found = predicates_.find(complete);
    if (found != predicates_.end()) return found->second;
  }
  // The name of a file's own namespace is as hidden as what is in it.
  const bool is_hidden =
      signature.ns != names::default_ns || functor.text.starts_with(kLocalNamespace);
  const Predicate id{static_cast<std::uint32_t>(predicate_count()) | (is_hidden ? kForeignBit : 0) |
                     (signature.negated ? kNegatedBit : 0)};
  predicates_.emplace(signatures_.emplace_back(complete), id);
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
  return table->signatures_[index - table->first_predicate_];
}

std::string_view SymbolTable::functor(Predicate predicate) const {
  return text(signature(predicate).functor);
}

}  // namespace jaywalk
