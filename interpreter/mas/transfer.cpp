#include "interpreter/mas/transfer.h"

#include <unordered_map>
#include <vector>

namespace jaywalk {
namespace {

class Transfer {
 public:
  explicit Transfer(Heap& to) : to_(to) {}

  Value copy(Value term) {
    term = deref(term);
    if (term.is_static() && term.is_closed() && !term.is_number()) return term;
    switch (term.kind()) {
      case Value::Kind::number:
      case Value::Kind::atom:
      case Value::Kind::special: return term;
      case Value::Kind::text: return to_.text(term.text()->view());
      case Value::Kind::variable: {
        const auto [entry, is_new] = variables_.try_emplace(term.bits());
        if (is_new) entry->second = to_.variable(term.variable()->name());
        return entry->second;
      }
      case Value::Kind::object: return Value::empty_list();  // a reference means nothing elsewhere
      case Value::Kind::pair:
      case Value::Kind::structure: break;
    }
    if (depth_ >= kMaxTermDepth) throw TermTooDeep{};
    ++depth_;
    const Value made = term.is_pair() ? list(term) : structure(*term.structure());
    --depth_;
    return made;
  }

 private:
  Value list(Value term) {
    std::vector<Value> elements;
    for (; term.is_pair(); term = deref(term.pair()->tail)) {
      elements.push_back(copy(term.pair()->head));
    }
    return to_.list(elements, copy(term));
  }

  Value structure(const Structure& s) {
    std::vector<Value> args;
    args.reserve(s.arity);
    for (const Value arg : s.arg_span()) args.push_back(copy(arg));
    return to_.structure(s.predicate(), args, copy(s.annots()), s.form());
  }

  Heap& to_;
  std::unordered_map<std::uint64_t, Value> variables_;
  int depth_ = 0;
};

}  // namespace

Value transfer(Value term, Heap& to) { return Transfer(to).copy(term); }

}  // namespace jaywalk
