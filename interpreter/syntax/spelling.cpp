#include "interpreter/syntax/spelling.h"

namespace jaywalk {

using ast::BodyOperator;
using ast::Operator;

std::string_view spelling_of(Operator op) {
  switch (op) {
    case Operator::none:
      return "";
    case Operator::negative:
      return "-";
    case Operator::positive:
      return "+";
    case Operator::logical_not:
      return "not ";
    case Operator::logical_and:
      return " & ";
    case Operator::logical_or:
      return " | ";
    case Operator::less:
      return " < ";
    case Operator::less_equal:
      return " <= ";
    case Operator::greater:
      return " > ";
    case Operator::greater_equal:
      return " >= ";
    case Operator::equal:
      return " == ";
    case Operator::not_equal:
      return " \\== ";
    case Operator::unify:
      return " = ";
    case Operator::univ:
      return " =.. ";
    case Operator::add:
      return "+";
    case Operator::subtract:
      return "-";
    case Operator::multiply:
      return "*";
    case Operator::divide:
      return "/";
    case Operator::int_divide:
      return " div ";
    case Operator::modulo:
      return " mod ";
    case Operator::power:
      return "**";
  }
  return "";
}

std::string_view spelling_of(BodyOperator op) {
  switch (op) {
    case BodyOperator::none:
      return "";
    case BodyOperator::achieve:
      return "!";
    case BodyOperator::achieve_new_focus:
      return "!!";
    case BodyOperator::test:
      return "?";
    case BodyOperator::add:
      return "+";
    case BodyOperator::add_new_focus:
      return "++";
    case BodyOperator::add_begin:
      return "+<";
    case BodyOperator::add_end:
      return "+>";
    case BodyOperator::remove:
      return "-";
    case BodyOperator::remove_new_focus:
      return "--";
    case BodyOperator::replace:
      return "-+";
  }
  return "";
}

std::string_view spelling_of(const ast::Trigger& trigger) {
  using ast::TriggerKind;
  using ast::TriggerOperator;
  const bool add = trigger.op == TriggerOperator::add;
  const bool remove = trigger.op == TriggerOperator::remove;
  switch (trigger.kind) {
    case TriggerKind::belief:
      return add ? "+" : remove ? "-" : "^";
    case TriggerKind::achieve:
      return add ? "+!" : remove ? "-!" : "^!";
    case TriggerKind::test:
      return add ? "+?" : remove ? "-?" : "^?";
  }
  return "";
}

}  // namespace jaywalk
