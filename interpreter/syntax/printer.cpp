// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/printer.h"

#include <cmath>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/syntax/precedence.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Operator;
using ast::Statement;

Precedence precedence_of_node(const Node& node) {
  const bool is_operation = node.kind == Kind::unary || node.kind == Kind::binary;
  return is_operation && !node.parenthesised ? precedence_of(node.op) : Precedence::primary;
}

Precedence tighter(Precedence precedence) {
  return static_cast<Precedence>(static_cast<int>(precedence) + 1);
}

bool is_plain_true(const ast::Formula& formula) {
  return formula.op == BodyOperator::none && formula.node->kind == Kind::truth &&
         formula.node->text == "true";
}

bool is_parenthesised_body(const Node& node) {
  return node.kind == Kind::body && node.parenthesised;
}

class Printer {
 public:
  [[nodiscard]] std::string take() && { return std::move(text_); }

  void expression(const Node& node, Precedence at_least = Precedence::none) {
    const bool parentheses = node.kind != Kind::body && node.parenthesised;
    if (parentheses || precedence_of_node(node) < at_least) {
      text_ += '(';
      bare(node);
      text_ += ')';
    } else {
      bare(node);
    }
  }

  void formula(const ast::Formula& formula) {
    const std::span<const Node* const> args = formula.node->args;
    switch (formula.statement) {
      case Statement::formula:
        plain_formula(formula);
        return;
      case Statement::if_statement:
        if_statement(args);
        return;
      case Statement::for_loop:
        text_ += "for (";
        loop(args);
        return;
      case Statement::while_loop:
        text_ += "while (";
        loop(args);
        return;
      case Statement::fork_and:
        fork(args, " |&| ");
        return;
      case Statement::fork_or:
        fork(args, " ||| ");
        return;
    }
  }

  void trigger(const ast::Trigger& trigger) {
    text_ += spelling_of(trigger);
    bare(*trigger.literal);
  }

  void plan(const ast::Plan& plan) {
    plan_without_stop(plan);
    text_ += '.';
    if (plan.subplans.empty()) return;
    text_ += " { ";
    for (const ast::Plan* subplan : plan.subplans) {
      this->plan(*subplan);
      text_ += ' ';
    }
    text_ += '}';
  }

  void component(const ast::Component& component) {
    switch (component.kind) {
      case ast::ComponentKind::belief:
        bare(*component.literal);
        if (component.body != nullptr) {
          text_ += " :- ";
          expression(*component.body);
        }
        text_ += '.';
        return;
      case ast::ComponentKind::goal:
        text_ += '!';
        bare(*component.literal);
        text_ += '.';
        return;
      case ast::ComponentKind::plan:
        plan(*component.plan);
        return;
      case ast::ComponentKind::directive:
        directive(component);
        return;
    }
  }

  void components(std::span<const ast::Component> components) {
    for (const ast::Component& one : components) {
      component(one);
      text_ += '\n';
    }
  }

 private:
  // The node without the parentheses around it.
  void bare(const Node& node) {
    switch (node.kind) {
      case Kind::number:
        number(node.number);
        return;
      case Kind::string:
        string(node.text);
        return;
      case Kind::variable:
      case Kind::literal:
        literal(node);
        return;
      case Kind::truth:
        text_ += node.text;
        return;
      case Kind::list:
        list(node);
        return;
      case Kind::unary:
        unary(node);
        return;
      case Kind::binary:
        binary(node);
        return;
      case Kind::body:
        body_in_braces(node.formulas);
        return;
      case Kind::trigger:
        text_ += "{ ";
        trigger(*node.trigger);
        text_ += " }";
        return;
      case Kind::plan:
        text_ += "{ ";
        plan_without_stop(*node.plan);
        text_ += " }";
        return;
      case Kind::rule:
        text_ += "{ ";
        bare(*node.args[0]);
        text_ += " :- ";
        expression(*node.args[1]);
        text_ += " }";
        return;
    }
  }

  void number(double value) {
    text_ += std::isinf(value) ? std::string("1e999") : fmt::format("{}", value);
  }

  void string(std::string_view value) {
    text_ += '"';
    for (const char c : value) {
      if (c == '\n') {
        text_ += "\\n";
      } else if (c == '"') {
        text_ += "\\\"";
      } else {
        text_ += c;
      }
    }
    text_ += '"';
  }

  void literal(const Node& node) {
    if (node.ns != nullptr) text_ += node.ns->text;
    if (node.ns != nullptr || node.this_namespace) text_ += "::";
    if (node.negated) text_ += '~';
    text_ += node.text;
    if (!node.args.empty()) {
      text_ += '(';
      for (const Node* argument : node.args) {
        if (argument != node.args.front()) text_ += ',';
        expression(*argument);
      }
      text_ += ')';
    }
    if (node.annots != nullptr) list(*node.annots);
  }

  void list(const Node& node) {
    text_ += '[';
    for (const Node* element : node.args) {
      if (element != node.args.front()) text_ += ',';
      expression(*element, Precedence::sum);
    }
    if (node.tail != nullptr) {
      text_ += '|';
      bare(*node.tail);
    }
    text_ += ']';
  }

  void unary(const Node& node) {
    text_ += spelling_of(node.op);
    expression(*node.args[0],
               node.op == Operator::logical_not ? Precedence::relation : Precedence::primary);
  }

  void binary(const Node& node) {
    const Precedence own = precedence_of(node.op);
    const bool to_the_right = is_right_associative(own);
    const bool to_the_left = !to_the_right && own != Precedence::relation;
    expression(*node.args[0], to_the_left ? own : tighter(own));
    text_ += spelling_of(node.op);
    const std::size_t right = text_.size();
    expression(*node.args[1], to_the_right ? own : tighter(own));
    // `X-` and `-1` must not become `X--1`.
    const bool sign_follows = text_[right] == '-' || text_[right] == '+';
    if (own == Precedence::sum && sign_follows) text_.insert(right, 1, ' ');
  }

  // A formula that begins with a sign would be an addition or a deletion.
  void plain_formula(const ast::Formula& formula) {
    const Node& node = *formula.node;
    if (is_parenthesised_body(node)) {
      body_in_parentheses(node.formulas);
      return;
    }
    text_ += spelling_of(formula.op);
    const std::size_t begin = text_.size();
    expression(node);
    const bool begins_with_sign = text_[begin] == '-' || text_[begin] == '+';
    if (begins_with_sign) {
      text_.insert(begin, 1, '(');
      text_ += ')';
    }
  }

  void formulas(std::span<const ast::Formula> body) {
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (i > 0) text_ += "; ";
      formula(body[i]);
    }
  }

  // Something that only a body has must be in there, or else this is an expression.
  void body_in_parentheses(std::span<const ast::Formula> body) {
    text_ += '(';
    formulas(body);
    text_ += body.size() == 1 && body.front().statement == Statement::formula ? ";)" : ")";
  }

  void body_in_braces(std::span<const ast::Formula> body) {
    text_ += "{ ";
    formulas(body);
    text_ += body.empty() ? "}" : " }";
  }

  void if_statement(std::span<const Node* const> args) {
    text_ += "if (";
    expression(*args[0]);
    text_ += ") ";
    body_in_braces(args[1]->formulas);
    if (args.size() < 3) return;
    const std::span<const ast::Formula> otherwise = args[2]->formulas;
    if (otherwise.size() == 1 && otherwise.front().statement == Statement::if_statement) {
      text_ += " el";
      formula(otherwise.front());
    } else {
      text_ += " else ";
      body_in_braces(otherwise);
    }
  }

  void loop(std::span<const Node* const> args) {
    expression(*args[0]);
    text_ += ") ";
    body_in_braces(args[1]->formulas);
  }

  void fork(std::span<const Node* const> args, std::string_view separator) {
    for (std::size_t i = 1; i < args.size(); ++i) {
      if (i > 1) text_ += separator;
      const std::span<const ast::Formula> body = args[i]->formulas;
      const bool is_plain = body.size() == 1 && body.front().statement == Statement::formula &&
                            !is_parenthesised_body(*body.front().node);
      if (is_plain) {
        formula(body.front());
      } else {
        body_in_parentheses(body);
      }
    }
  }

  void plan_without_stop(const ast::Plan& plan) {
    if (plan.label != nullptr) {
      text_ += '@';
      bare(*plan.label);
      text_ += ' ';
    }
    trigger(plan.trigger);
    if (plan.context != nullptr) {
      text_ += " : ";
      expression(*plan.context);
    }
    if (plan.goal_condition != nullptr) {
      text_ += " <: ";
      expression(*plan.goal_condition);
    }
    if (!plan.has_body) return;
    text_ += " <- ";
    // The parser drops one of these.
    if (!plan.body.empty() && is_plain_true(plan.body.front())) text_ += "true; ";
    formulas(plan.body);
  }

  void directive(const ast::Component& component) {
    text_ += component.is_block ? "{ begin " : "{ ";
    bare(*component.literal);
    text_ += " }";
    if (!component.is_block) return;
    text_ += '\n';
    components(component.inner);
    text_ += "{ end }";
  }

  std::string text_;
};

}  // namespace

std::string print(const ast::Node& node) {
  Printer printer;
  printer.expression(node);
  return std::move(printer).take();
}

std::string print(const ast::Formula& formula) {
  Printer printer;
  printer.formula(formula);
  return std::move(printer).take();
}

std::string print(const ast::Trigger& trigger) {
  Printer printer;
  printer.trigger(trigger);
  return std::move(printer).take();
}

std::string print(const ast::Plan& plan) {
  Printer printer;
  printer.plan(plan);
  return std::move(printer).take();
}

std::string print(const ast::Component& component) {
  Printer printer;
  printer.component(component);
  return std::move(printer).take();
}

std::string print(const ast::File& file) {
  Printer printer;
  printer.components(file.components);
  return std::move(printer).take();
}

}  // namespace jaywalk
