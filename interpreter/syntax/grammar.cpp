// SPDX-License-Identifier: Apache-2.0
// The grammar of AgentSpeak, in Boost.Spirit X3 over tokens (token_parsers.h). Its actions put the
// tree together in a Builder; there are no attributes. It decides by the next token (two for a
// namespace) and then expects what must follow, so that it never goes back and every failure is an
// error. Nobody else includes token_parsers.h, and with it Boost.Spirit.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/syntax_error.h"
#include "interpreter/syntax/token_parsers.h"

namespace jaywalk::grammar {
namespace {

// --- Sets of tokens --------------------------------------------------------------------------

using K = TokenKind;

constexpr std::uint64_t kName = set_of(K::atom, K::begin_word, K::end_word);
constexpr std::uint64_t kLiteral =
    kName | set_of(K::variable, K::tilde, K::double_colon, K::true_word, K::false_word);
constexpr std::uint64_t kOpen = set_of(K::open, K::body_open);
constexpr std::uint64_t kOperand =
    kLiteral | kOpen | set_of(K::number, K::string, K::open_list, K::open_brace, K::plus, K::minus);
constexpr std::uint64_t kExpression = kOperand | bit(K::not_word);
constexpr std::uint64_t kArithmetic =
    set_of(K::plus, K::minus, K::times, K::divide, K::div_word, K::mod_word, K::power);
constexpr std::uint64_t kInfix =
    kArithmetic | set_of(K::bar, K::ampersand, K::less, K::less_equal, K::greater, K::greater_equal,
                         K::equal, K::not_equal, K::unify, K::univ);
constexpr std::uint64_t kGoalOperator = set_of(K::bang, K::double_bang);
constexpr std::uint64_t kBeliefOperator =
    set_of(K::question, K::plus, K::plus_plus, K::plus_less, K::plus_greater, K::minus,
           K::minus_minus, K::minus_plus);
constexpr std::uint64_t kFormula = kExpression | kGoalOperator | kBeliefOperator;
constexpr std::uint64_t kStatement = set_of(K::if_word, K::for_word, K::while_word);
// Tokens that begin a formula after another one without a semicolon: always, and if it looks so.
constexpr std::uint64_t kNeverClause = kGoalOperator | kStatement | bit(K::question);
constexpr std::uint64_t kNoSemicolon =
    set_of(K::atom, K::variable, K::tilde, K::plus_plus, K::plus_less, K::plus_greater,
           K::minus_minus, K::minus_plus);
constexpr std::uint64_t kTrigger = set_of(K::plus, K::minus, K::caret);
constexpr std::uint64_t kTriggerKind = set_of(K::bang, K::question);
constexpr std::uint64_t kPlan = kTrigger | bit(K::at);
constexpr std::uint64_t kComponent = kPlan | kLiteral | set_of(K::bang, K::open_brace);

const Terminal stop{K::stop};
const Terminal comma{K::comma};
const Terminal colon{K::colon};
const Terminal arrow{K::arrow};
const Terminal if_rule{K::rule};
const Terminal goal_condition{K::goal_condition};
const Terminal bar{K::bar};
const Terminal bang{K::bang};
const Terminal close{K::close};
const Terminal open_list{K::open_list};
const Terminal close_list{K::close_list};
const Terminal open_brace{K::open_brace};
const Terminal close_brace{K::close_brace};
const Terminal open{kOpen, "'('"};
const Terminal name{kName, "a name"};
const Terminal variable{K::variable};
const Ahead end_of_text{bit(K::end_of_text), "the end of the text"};

// --- Terms -----------------------------------------------------------------------------------

using Builder = jaywalk::Builder;

const x3::rule<struct expression_tag> expression = "a term";
const x3::rule<struct element_tag> element = "a term";
const x3::rule<struct operand_tag> operand = "a term";
const x3::rule<struct literal_tag> literal = "a literal";
const x3::rule<struct list_tag> list = "a list";
const x3::rule<struct brace_tag> brace = "'{'";
const x3::rule<struct body_tag> body = "a plan body";

const auto enter = act<&Builder::enter>;
const auto leave = act<&Builder::leave>;

const auto arguments = open > enter > expression > *(comma > expression) > close > leave
                       > act<&Builder::end_arguments>;

const auto annotations =
    Ahead{bit(K::open_list), "annotations"} > list > act<&Builder::attach_annotations>;

const auto namespace_prefix =
    (Ahead{kName | bit(K::variable), bit(K::double_colon), "a namespace"} >
     Terminal{kName | bit(K::variable), "a namespace"} > act<&Builder::namespace_prefix> >
     Terminal{K::double_colon}) |
    (Terminal{K::double_colon} > act<&Builder::this_namespace_prefix>);

const auto literal_def =
    (Terminal{set_of(K::true_word, K::false_word), "a literal"} > act<&Builder::truth>) |
    (Ahead{kLiteral, "a literal"} > -namespace_prefix >
     -(Terminal{K::tilde} > act<&Builder::tilde>) >
     ((variable > act<&Builder::begin_variable>) |
      (name > act<&Builder::begin_literal> > -arguments)) > -annotations >
     act<&Builder::end_literal>);

const auto list_def = open_list > enter > act<&Builder::begin_list> >
                      -(Ahead{kOperand, "a term"} > element > *(comma > element)) >
                      -(bar > (list | (variable > act<&Builder::begin_variable> >
                                       act<&Builder::end_literal>)) >
                        act<&Builder::list_tail>) > close_list
                      > leave > act<&Builder::end_list>;

const auto operand_def = literal | (Terminal{K::number} > act<&Builder::number>) |
                         (Terminal{K::string} > act<&Builder::string>) | list | brace |
                         (open > enter > expression > close > leave > act<&Builder::parenthesised>);

const auto signed_operand =
    -(Terminal{set_of(K::plus, K::minus), "a sign"} > act<&Builder::prefix_operator>) > operand;

// Precedence is the builder's concern, see Builder::infix_operator.
const auto expression_operand =
    -(Terminal{K::not_word} > act<&Builder::prefix_operator>) > signed_operand;

const auto expression_def = Ahead{kExpression, "a term"} > act<&Builder::begin_expression> >
                            expression_operand >
                            *(Terminal{kInfix, "an operator"} > act<&Builder::infix_operator> >
                              expression_operand) > act<&Builder::end_expression>;

// A logical expression in a list needs parentheses: `|` begins the tail there.
const auto element_def = Ahead{kOperand, "a term"} > act<&Builder::begin_expression> >
                         signed_operand >
                         *(Terminal{kArithmetic, "an operator"} > act<&Builder::infix_operator> >
                           signed_operand) > act<&Builder::end_expression>;

BOOST_SPIRIT_DEFINE(expression, element, operand, literal, list)

// --- Plan bodies -----------------------------------------------------------------------------

const x3::rule<struct body_term_tag> body_term = "a formula";
const x3::rule<struct body_factor_tag> body_factor = "a formula";
const x3::rule<struct formula_tag> formula = "a formula";
const x3::rule<struct statement_tag> statement = "a statement";
const x3::rule<struct condition_tag> condition = "'('";
const x3::rule<struct block_tag> block = "'{'";
const x3::rule<struct if_rest_tag> if_rest = "'('";

const auto formula_def =
    Ahead{kFormula, "a formula"} > act<&Builder::begin_formula> >
    ((Terminal{kGoalOperator, "a goal"} > act<&Builder::formula_operator> > literal) |
     (-(Terminal{kBeliefOperator, "an operator"} > act<&Builder::formula_operator>) >
      ((Terminal{K::body_open} > enter > body > close > leave >
        act<&Builder::end_parenthesised_body>) |
       expression))) > act<&Builder::end_formula>;

const auto body_factor_def = formula >
                             -(Ahead{bit(K::fork_and), "'|&|'"} > act<&Builder::begin_fork> >
                               +(Terminal{K::fork_and} > formula) > act<&Builder::end_fork_and>);

const auto body_term_def = body_factor >
                           -(Ahead{bit(K::fork_or), "'|||'"} > act<&Builder::begin_fork> >
                             +(Terminal{K::fork_or} > body_factor) > act<&Builder::end_fork_or>);

const auto semicolon = Terminal{K::semicolon} > act<&Builder::semicolon>;
// As in older Jasons, where semicolons are optional.
const auto missing_semicolon =
    (Ahead{kNeverClause, "a formula"} |
     (Ahead{kNoSemicolon, "a formula"} >> act<&Builder::formula_follows>)) >
    act<&Builder::missing_semicolon>;

// Leaves the frame of begin_body; the rule that uses the body ends it.
const auto body_def = act<&Builder::begin_body> >
                      *(act<&Builder::may_continue> >>
                        ((Ahead{kStatement, "a statement"} > statement > -semicolon) |
                         (Ahead{kFormula, "a formula"} > body_term >
                          -(semicolon | missing_semicolon))));

const auto block_def =
    open_brace > enter > body > close_brace > leave > act<&Builder::end_body_as_term>;

const auto condition_def =
    open > enter > expression > act<&Builder::check_condition> > close > leave;

const auto if_rest_def = condition > block >
                         -((Terminal{K::elif_word} > act<&Builder::begin_statement> > enter >
                            if_rest > leave > act<&Builder::elif_as_term>) |
                           (Terminal{K::else_word} > block)) > act<&Builder::end_if>;

const auto statement_def = (Terminal{K::if_word} > act<&Builder::begin_statement> > if_rest) |
                           (Terminal{K::for_word} > act<&Builder::begin_statement> > condition >
                            block > act<&Builder::end_for>) |
                           (Terminal{K::while_word} > act<&Builder::begin_statement> > condition >
                            block > act<&Builder::end_while>);

BOOST_SPIRIT_DEFINE(body, body_term, body_factor, formula, statement, condition, block, if_rest)

// --- Plans -----------------------------------------------------------------------------------

const x3::rule<struct plan_tag> plan = "a plan";

// As in older Jasons: `@found(_)[atomic]`.
const auto label_arguments = Ahead{kOpen, "'('"} > act<&Builder::label_arguments> > arguments;

const auto label = Terminal{K::at} >
                   Ahead{kName | set_of(K::variable, K::open_list), "the label of a plan"} >
                   (list | (((name > act<&Builder::begin_literal> > -label_arguments) |
                             (variable > act<&Builder::begin_variable>)) > -annotations >
                            act<&Builder::end_label>)) > act<&Builder::plan_label>;

const auto trigger = Terminal{kTrigger, "a trigger"} > act<&Builder::trigger_operator> >
                     -(Terminal{kTriggerKind, "'!' or '?'"} > act<&Builder::trigger_kind>) > literal
                     > act<&Builder::end_trigger>;

const auto context = colon > expression > act<&Builder::plan_context>;

const auto arrow_and_body = arrow > body > act<&Builder::plan_body>;

const auto unfinished_plan = Ahead{kPlan, "a plan"} > act<&Builder::begin_plan> > -label > trigger >
                             -context >
                             -(goal_condition > expression > act<&Builder::plan_goal_condition>) >
                             -arrow_and_body;

const auto subplans = Ahead{bit(K::open_brace), kPlan | bit(K::close_brace), "sub-plans"} >
                      open_brace > enter > *(plan > act<&Builder::subplan>) > close_brace > leave;

const auto plan_def = unfinished_plan > stop > -subplans > act<&Builder::end_plan>;

// `{ +b; c }` is a body and `{ +b : c <- d }` a plan; the first formula of a body may turn out to
// have been a trigger.
const auto plan_in_brace = -context > -arrow_and_body > act<&Builder::plan_brace>;

const auto begins_plan_in_brace = Ahead{set_of(K::at, K::caret), "a plan"} |
                                  Ahead{set_of(K::plus, K::minus), kTriggerKind, "a plan"};

const auto brace_def = open_brace > enter > act<&Builder::begin_brace> >
                       ((Ahead{bit(K::close_brace), "'}'"} > act<&Builder::empty_brace>) |
                        (begins_plan_in_brace > act<&Builder::begin_plan> > -label > trigger >
                         plan_in_brace) |
                        (body > ((if_rule > expression > act<&Builder::rule_brace>) |
                                 (Ahead{set_of(K::colon, K::arrow), "a plan"} >
                                  act<&Builder::plan_brace_from_body> > plan_in_brace) |
                                 act<&Builder::body_brace>))) > close_brace
                       > leave > act<&Builder::end_brace>;

BOOST_SPIRIT_DEFINE(plan, brace)

// --- Recovery --------------------------------------------------------------------------------

// Reports that the parser failed at a token, and returns the token at which it goes on.
Iterator recover(Builder& builder, Iterator found, const std::string& expected) {
  Diagnostics diagnostics;
  Iterator next = nullptr;
  if (auto failure = builder.take_failure()) {
    diagnostics.error({builder.source(), failure->span}, std::move(failure->message),
                      std::move(failure->hint));
    next = next_clause(builder.tokens(), builder.clause(), found);
  } else {
    next = report({.source = builder.source(),
                   .tokens = builder.tokens(),
                   .clause = builder.clause(),
                   .found = found,
                   .expected = expected},
                  diagnostics);
  }
  builder.recover(next);
  builder.diagnostics().append(std::move(diagnostics));
  return next;
}

// --- Programs --------------------------------------------------------------------------------

// Errors are caught here, so that each discards only its clause.
struct component_tag {
  template <class Context>
  x3::error_handler_result on_error(Iterator& first, const Iterator& /*last*/,
                                    const x3::expectation_failure<Iterator>& failure,
                                    const Context& where) const {
    first = recover(builder_of(where), failure.where(), failure.which());
    return x3::error_handler_result::accept;
  }
};

const x3::rule<component_tag> component = "a belief, goal, plan or directive";

const auto end_of_block = Ahead{bit(K::open_brace), bit(K::end_word), "{ end }"};

const auto directive_name = name > act<&Builder::begin_literal> > -arguments > -annotations >
                            act<&Builder::end_label> > act<&Builder::begin_directive>;

const auto directive = open_brace >
                       ((Terminal{K::begin_word} > directive_name > close_brace >
                         act<&Builder::begin_block> > enter > *component > end_of_block >
                         open_brace > Terminal{K::end_word} > close_brace > leave) |
                        (directive_name > close_brace)) > act<&Builder::end_directive>;

const auto goal = bang > literal > stop > act<&Builder::end_goal>;

const auto belief = literal > act<&Builder::belief_head> >
                    -(if_rule > expression > act<&Builder::belief_body>) > stop
                    > act<&Builder::end_belief>;

const auto component_def = (!end_of_block >> !end_of_text) > act<&Builder::begin_component> >
                           Ahead{kComponent, "a belief, goal, plan or directive"} >
                           (directive | goal | (plan > act<&Builder::end_plan_component>) |
                            belief) > act<&Builder::end_component>;

BOOST_SPIRIT_DEFINE(component)

const auto agent =
    *(component | (open_brace > act<&Builder::stray_end> > Terminal{K::end_word} > close_brace)) >
    end_of_text;

// --- Entry points ----------------------------------------------------------------------------

const auto single_term = expression > end_of_text;
const auto single_literal = literal > end_of_text;
const auto single_plan = unfinished_plan >
                         -(stop > -subplans) > act<&Builder::end_plan> > end_of_text;
const auto literals = -(literal > *(comma > literal)) > end_of_text;

// Matches all of the tokens; errors become diagnostics.
template <class Parser>
void parse(const Parser& parser, Builder& builder) {
  Iterator first = builder.tokens().data();
  const Iterator last = first + builder.tokens().size();
  try {
    x3::parse(first, last, x3::with<BuilderTag>(builder)[x3::eps > parser]);
  } catch (const x3::expectation_failure<Iterator>& failure) {
    recover(builder, failure.where(), failure.which());
  }
  builder.report_mistakes(std::numeric_limits<std::uint32_t>::max());
}

}  // namespace
}  // namespace jaywalk::grammar

namespace jaywalk {
namespace {

// Tokens and builder of one text.
template <class Parser, class Take>
auto parse_whole(const Parser& parser, const SourcePtr& source, ast::Arena& arena,
                 Diagnostics& diagnostics, Take take) {
  Diagnostics found;
  const std::vector<Token> tokens = tokenize(source, found);
  Builder builder(source, tokens, arena, found);
  grammar::parse(parser, builder);
  found.sort_by_place();
  const bool parsed = !found.has_errors();
  diagnostics.append(std::move(found));
  return parsed ? take(builder) : nullptr;
}

}  // namespace

ast::File parse_agent(SourcePtr source, Diagnostics& diagnostics) {
  // A tree is some 20 times as large as its text; the arena grows by itself.
  ast::File file;
  file.arena = std::make_unique<ast::Arena>(source->text().size() * 8 + 1024);
  Diagnostics found;
  const std::vector<Token> tokens = tokenize(source, found);
  Builder builder(source, tokens, *file.arena, found);
  grammar::parse(grammar::agent, builder);
  file.components = builder.components();
  file.source = std::move(source);
  found.sort_by_place();
  diagnostics.append(std::move(found));
  return file;
}

const ast::Node* parse_term(const SourcePtr& source, ast::Arena& arena, Diagnostics& diagnostics) {
  return parse_whole(grammar::single_term, source, arena, diagnostics,
                     [](Builder& builder) { return builder.value(); });
}

const ast::Node* parse_literal(const SourcePtr& source, ast::Arena& arena,
                               Diagnostics& diagnostics) {
  return parse_whole(grammar::single_literal, source, arena, diagnostics,
                     [](Builder& builder) { return builder.value(); });
}

const ast::Plan* parse_plan(const SourcePtr& source, ast::Arena& arena, Diagnostics& diagnostics) {
  return parse_whole(grammar::single_plan, source, arena, diagnostics,
                     [](Builder& builder) { return builder.plan(); });
}

const ast::Node* parse_literals(const SourcePtr& source, ast::Arena& arena,
                                Diagnostics& diagnostics) {
  return parse_whole(grammar::literals, source, arena, diagnostics,
                     [](Builder& builder) { return builder.values_as_list(); });
}

}  // namespace jaywalk
