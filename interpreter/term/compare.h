// SPDX-License-Identifier: Apache-2.0
#pragma once

// Equality, order and hashes of terms.

#include <cstdint>
#include <vector>

#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

enum class Annotations { compare, ignore };

/// `==`: equal numbers; strings; lists by element; structures of the same predicate with equal
/// arguments and, if asked, equal sets of annotations. Unbound variables equal themselves alone.
[[nodiscard]] bool equal_terms(Value a, Value b, Annotations annotations = Annotations::compare);

/// Jason's order: number < string < list < literal < object < variable; negative, zero, positive as
/// usual. Literals by namespace, functor, `~` last, arguments from the left, arity, annotations.
[[nodiscard]] int compare_terms(Value a, Value b, const SymbolTable& symbols);

/// Equal terms have equal hashes; annotations do not count. 0 for terms with unbound variables.
[[nodiscard]] std::uint64_t hash_term(Value term);

/// Whether a term has no unbound variables.
[[nodiscard]] bool is_ground(Value term);

/// The annotations as a sorted set: sorted by compare_terms, duplicates dropped; an open tail
/// stays.
[[nodiscard]] Value sorted_set(Heap& heap, Value list, const SymbolTable& symbols);
/// Like sorted_set() above, for elements that precede a tail.
[[nodiscard]] Value sorted_set(Heap& heap, std::vector<Value> elements, Value tail,
                               const SymbolTable& symbols);
/// Appends a list's elements; the result is its tail, or the term if it is no list.
[[nodiscard]] Value append_elements(std::vector<Value>& elements, Value list);

/// Union of two closed sets of annotations.
[[nodiscard]] Value union_of(Heap& heap, Value a, Value b, const SymbolTable& symbols);

}  // namespace jaywalk
