#pragma once

// Words of a vocabulary and how messages name numbers of arguments.

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/check/check.h"

namespace jaywalk {

/// Whether one name is likely a slip for the other: long enough, and not distinguished on purpose
/// as `left1` and `left2` are, `pos_x` and `pos_y`, `bid` and `bids`.
[[nodiscard]] bool is_misspelling(std::string_view name, std::string_view meant);

/// Whether one word becomes the other by one letter more, less or changed, or by two neighbours
/// that change places: a Damerau-Levenshtein distance of 1.
[[nodiscard]] bool is_one_slip(std::string_view a, std::string_view b);

/// "1 or 2 arguments"
[[nodiscard]] std::string counted(const std::set<int>& arities);
[[nodiscard]] std::string counted(const Vocabulary::Entry& entry);

/// The first entry of that name, or null.
/// `.print` for `jason.stdlib.print`; other names as they are.
[[nodiscard]] std::string_view short_name(std::string_view action);
[[nodiscard]] const Vocabulary::Entry* entry_of(std::span<const Vocabulary::Entry> entries,
                                                std::string_view name);
[[nodiscard]] bool takes(const Vocabulary::Entry& entry, int arity);
[[nodiscard]] std::vector<std::string> names_of(std::span<const Vocabulary::Entry> entries);

}  // namespace jaywalk
