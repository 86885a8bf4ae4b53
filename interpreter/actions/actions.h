#pragma once

// The standard internal actions, declared from their table.

#include "interpreter/logic/action.h"

namespace jaywalk::actions {

#define JAYWALK_ACTION(function, least, most, kind, signature, summary) Outcome function(ActionCall&);
#include "interpreter/actions/actions.def"
#undef JAYWALK_ACTION

/// The elements of a list, dereferenced; what is not a list gives none.
[[nodiscard]] std::vector<Value> elements(Value list);

/// The text of an argument: a string's content, anything else as it prints.
[[nodiscard]] std::string text_of(Value value, const SymbolTable& symbols);

/// The solutions of an action that are known beforehand: each is unified with one argument.
class ValueSolutions : public Solutions {
 public:
  ValueSolutions(std::size_t argument, std::vector<Value> values)
      : argument_(argument), values_(std::move(values)) {}
  bool next(ActionCall& call) override {
    while (next_ < values_.size()) {
      if (call.unify(argument_, values_[next_++])) return true;
    }
    return false;
  }

 private:
  std::size_t argument_;
  std::vector<Value> values_;
  std::size_t next_ = 0;
};

}  // namespace jaywalk::actions
