#include "interpreter/logic/beliefs/constant_percepts.h"

#include <algorithm>
#include <utility>

#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

bool is_lasting(Value value, std::uint32_t names) {
  return !value.is_atom() || static_cast<std::uint32_t>(value.atom_id()) < names;
}

bool has_fact(const Ring<Row>& rows, std::span<const Value> args) {
  for (const Row& row : rows) {
    const std::span<const Value> known = row.fact.structure()->arg_span();
    const bool same = std::equal(args.begin(), args.end(), known.begin(), known.end(),
                                 [](Value a, Value b) { return equal_terms(a, b); });
    if (same) return true;
  }
  return false;
}

// As belief update makes it.
Row row_of(Heap& heap, Predicate predicate, std::span<const Value> args) {
  Structure* const made = heap.blank_literal(predicate, args.size(), source_percept());
  std::copy(args.begin(), args.end(), made->args());
  const bool closed = std::ranges::all_of(args, [](Value arg) { return arg.is_closed(); });
  return {.fact = heap.literal_of(made, closed),
          .key = args.empty() ? 0 : argument_key(args[0]),
          .percept_generation = SharedRows::kAlwaysSeen};
}

// What is said of a predicate; nothing, if not all of that may be shared.
Ring<Row> rows_of(Heap& heap, Predicate predicate, std::span<const ConstantPercepts::Percept> said,
                  std::uint32_t names) {
  Ring<Row> rows;
  for (const ConstantPercepts::Percept& each : said) {
    if (each.predicate != predicate) continue;
    const std::span<const Value> args = each.args;
    const bool lasts = std::ranges::all_of(args, [&](Value arg) { return is_lasting(arg, names); });
    if (!lasts || has_fact(rows, args)) return {};
    rows.push_back(row_of(heap, predicate, args));
  }
  return rows;
}

}  // namespace

ConstantPercepts::ConstantPercepts(std::span<const Percept> said, std::uint32_t names) {
  std::vector<Predicate> predicates;
  for (const auto& [predicate, args] : said) {
    if (static_cast<std::uint32_t>(predicate) >= names) continue;
    if (std::ranges::find(predicates, predicate) != predicates.end()) continue;
    predicates.push_back(predicate);
    Ring<Row> rows = rows_of(heap_, predicate, said, names);
    if (rows.empty()) continue;
    by_predicate_.insert(static_cast<std::uint32_t>(predicate),
                         static_cast<std::uint32_t>(rows_.size()));
    rows_.push_back(std::make_unique<const SharedRows>(std::move(rows), nullptr));
  }
}

}  // namespace jaywalk
