// SPDX-License-Identifier: Apache-2.0
// Runs random statements about beliefs and compares the remaining beliefs, the values of variables
// and the events with those of a plain list (belief_list.h). Patterns are made from beliefs by
// replacing parts with variables.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/helpers/generate.h"
#include "tests/helpers/run_agents.h"
#include "tests/property/engine/belief_list.h"

namespace jaywalk {
namespace {

using test::BeliefList;
using test::Bindings;
using test::Term;

Term variable(std::string name) { return {.kind = Term::Kind::variable, .name = std::move(name)}; }
Term literal(std::string name, std::vector<Term> args = {}, std::vector<Term> annots = {}) {
  return {.name = std::move(name), .args = std::move(args), .annots = std::move(annots)};
}
Term number(std::string digits) { return {.kind = Term::Kind::number, .name = std::move(digits)}; }
Term quoted(std::string text) { return {.kind = Term::Kind::text, .name = std::move(text)}; }
Term list(std::vector<Term> elements) {
  return {.kind = Term::Kind::list, .args = std::move(elements)};
}

const std::vector<Term>& predicates() {
  static const std::vector<Term> all{literal("p", {variable("X")}), literal("~p", {variable("X")}),
                                     literal("p", {variable("X"), variable("Y")}),
                                     literal("q", {variable("X")}), literal("z")};
  return all;
}

const std::vector<Term>& arguments() {
  static const std::vector<Term> all{literal("a"),
                                     number("1"),
                                     literal("f", {literal("a")}),
                                     quoted("\"s\""),
                                     literal("f", {literal("g", {number("1")})}),
                                     list({literal("a"), number("1")}),
                                     literal("k", {}, {literal("t", {number("1")})}),
                                     literal("~f", {literal("a")}),
                                     list({})};
  return all;
}

const std::vector<Term>& annotations() {
  static const std::vector<Term> all{number("3"),
                                     quoted("\"x\""),
                                     literal("u"),
                                     literal("source", {literal("ann")}),
                                     literal("source", {literal("bob")}),
                                     literal("source", {literal("self")}),
                                     literal("t", {number("1")}),
                                     literal("t", {number("2")}),
                                     literal("w", {literal("f", {literal("a")})})};
  return all;
}

/// A program that runs one statement after another and prints the effect of each, and the lines
/// that it must print.
class Script {
 public:
  Script(std::uint64_t seed, std::size_t initial_beliefs) : choices_(seed) {
    argument_kinds_ = 2 + choices_.below(arguments().size() - 1);
    annotation_kinds_ = 3 + choices_.below(annotations().size() - 2);
    write_event_plans();
    write_initial_beliefs(initial_beliefs);
    constexpr std::size_t kStatements = 16;
    text_ += "!s0.\n";
    for (std::size_t i = 0; i < kStatements; ++i) write_statement(i);
    text_ += fmt::format("+!s{} <- true", kStatements);
    for (const Term& predicate : predicates()) show_beliefs(predicate);
    text_ += ".\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<std::string>& expected() const { return expected_; }
  /// The number of deletions that bound a variable.
  [[nodiscard]] std::size_t open_deletions() const { return open_deletions_; }

 private:
  template <class Kind>
  const Kind& one_of(const std::vector<Kind>& all) {
    return all[choices_.below(all.size())];
  }
  void add(std::string_view step) { text_ += fmt::format("; {}", step); }

  void write_event_plans() {
    for (const Term& predicate : predicates()) {
      for (const std::string_view op : {"+", "-"}) {
        if (!choices_.once_in(2)) continue;
        const std::string event = test::text(predicate);
        heard_.push_back(std::string(op) + predicate.name + std::to_string(predicate.args.size()));
        text_ += fmt::format("{0}{1}[|A] <- .print(\"{0}\",{1},A).\n", op, event);
      }
    }
  }

  // Agents add them from the last to the first.
  void write_initial_beliefs(std::size_t count) {
    std::vector<Term> all;
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(choices_.once_in(2) ? literal("q", {number(std::to_string(i))}, some_annots())
                                        : ground_literal());
      text_ += test::text(all.back()) + ".\n";
    }
    while (!all.empty()) {
      if (const auto event = beliefs_.add(all.back(), BeliefList::Place::front)) {
        expect_event("+", *event);
      }
      all.pop_back();
    }
  }

  void write_statement(std::size_t number) {
    known_.clear();
    named_.clear();
    text_ += fmt::format("-!s{0} <- .print(no); !s{1}.\n+!s{0} <- .print({0})", number, number + 1);
    expected_.push_back(std::to_string(number));
    if (choices_.once_in(3)) {
      known_.emplace("B", argument());
      add("B = " + test::text(known_.at("B")));
    }
    const std::size_t kind = choices_.below(20);
    if (kind < 6) {
      write_addition();
    } else if (kind < 13) {
      write_deletion();
    } else if (kind < 15) {
      write_replacement();
    } else if (kind < 16) {
      write_abolition();
    } else {
      write_query(kind);
    }
    add(fmt::format("!s{}", number + 1));
    text_ += ".\n";
  }

  void write_addition() {
    const Term added = ground_literal();
    const std::string_view op = choices_.one_of({"+", "+", "+", "++", "+<", "+>"});
    add(std::string(op) + test::text(added));
    const auto place = op == "+>" ? BeliefList::Place::back : BeliefList::Place::front;
    if (const auto event = beliefs_.add(added, place)) expect_event("+", *event);
    settle(added);
  }

  void write_deletion() {
    Term pattern = opened_literal();
    // Jason leaves the variable after `|` open if the other annotations suffice.
    if (beliefs_.has_exactly(test::applied(pattern, known_))) drop_rest(pattern);
    const bool is_own = !choices_.once_in(5);
    add((is_own ? "-" : "--") + test::text(pattern));
    const auto removed = beliefs_.remove(test::applied(pattern, known_));
    if (removed) {
      expect_event("-", removed->event);
      if (!removed->bindings.empty()) ++open_deletions_;
    }
    settle(pattern);
    show_values(removed && is_own ? removed->bindings : Bindings{});
  }

  void write_replacement() {
    const Term added = ground_literal();
    add("-+" + test::text(added));
    if (const auto event = beliefs_.remove_for(added)) expect_event("-", *event);
    if (const auto event = beliefs_.add(added, BeliefList::Place::front)) expect_event("+", *event);
    settle(added);
  }

  void write_abolition() {
    const Term pattern = opened_literal();
    add(fmt::format(".abolish({})", test::text(pattern)));
    for (const Term& event : beliefs_.abolish(test::applied(pattern, known_))) {
      expect_event("-", event);
    }
    settle(pattern);
  }

  void write_query(std::size_t kind) {
    const Term query = opened_literal();
    const std::string asked = test::text(query);
    const std::vector<Bindings> answers = beliefs_.answers(test::applied(query, known_));
    if (kind == 16) {
      add(fmt::format(".count({},N); .print(N)", asked));
      expected_.push_back(std::to_string(answers.size()));
    } else if (kind == 17) {
      const Term found = list(names());
      add(fmt::format(".findall({},{},L); .print(L)", test::text(found), asked));
      std::vector<Term> all;
      for (const Bindings& answer : answers) all.push_back(test::applied(found, answer));
      expected_.push_back(test::text(list(std::move(all))));
    } else if (kind == 18) {
      const bool is_negated = choices_.once_in(2);
      add(fmt::format("if ({}{}) {{ .print(yes) }}", is_negated ? "not " : "", asked));
      if (answers.empty() == is_negated) expected_.emplace_back("yes");
    } else {
      add("?" + asked);
      if (answers.empty()) return expected_.push_back("no");
      show_values(answers.front());
    }
  }

  // Waits until external events are handled, too.
  void settle(const Term& changed) {
    add(".wait(1)");
    for (const Term& predicate : predicates()) {
      const bool is_it =
          predicate.name == changed.name && predicate.args.size() == changed.args.size();
      if (is_it) show_beliefs(predicate);
    }
  }

  void show_beliefs(const Term& predicate) {
    const std::string asked = test::text(predicate);
    add(fmt::format(".findall(b({0},A),{0}[|A],L_{1}{2}); .print(L_{1}{2})", asked,
                    predicate.name.front() == '~' ? "not" : predicate.name, predicate.args.size()));
    std::vector<Term> all;
    for (const Term& belief : beliefs_.all()) {
      if (belief.name != predicate.name || belief.args.size() != predicate.args.size()) continue;
      all.push_back(literal("b", {literal(belief.name, belief.args), list(belief.annots)}));
    }
    expected_.push_back(test::text(list(std::move(all))));
  }

  void show_values(const Bindings& values) {
    for (const Term& name : names()) {
      const auto value = values.find(name.name);
      add(fmt::format("if (.ground({0})) {{ .print([{0}]) }} else {{ .print(open) }}", name.name));
      expected_.push_back(value == values.end() ? "open" : test::text(list({value->second})));
    }
  }

  void expect_event(std::string_view op, const Term& event) {
    const std::string key = std::string(op) + event.name + std::to_string(event.args.size());
    if (std::find(heard_.begin(), heard_.end(), key) == heard_.end()) return;
    expected_.push_back(std::string(op) + test::text(literal(event.name, event.args)) +
                        test::text(list(event.annots)));
  }

  [[nodiscard]] std::vector<Term> names() const {
    std::vector<Term> all;
    for (const std::string& name : named_) all.push_back(variable(name));
    return all;
  }

  Term argument() { return arguments()[choices_.below(argument_kinds_)]; }
  Term annotation() { return annotations()[choices_.below(annotation_kinds_)]; }

  std::vector<Term> some_annots() {
    std::vector<Term> some;
    for (std::size_t left = choices_.below(4); left > 0; --left) some.push_back(annotation());
    return test::annotation_set(std::move(some));
  }

  // Usually a belief with some of its annotations and perhaps others.
  Term ground_literal() {
    const std::vector<Term>& believed = beliefs_.all();
    if (believed.empty() || choices_.once_in(3)) {
      Term made = one_of(predicates());
      for (Term& arg : made.args) arg = argument();
      made.annots = some_annots();
      return made;
    }
    Term made = one_of(believed);
    std::erase_if(made.annots, [&](const Term&) { return choices_.once_in(2); });
    if (choices_.once_in(3)) made.annots.push_back(annotation());
    if (!made.args.empty() && choices_.once_in(6)) made.args.back() = argument();
    made.annots = test::annotation_set(std::move(made.annots));
    return made;
  }

  // May have variables in arguments and in annotations.
  Term opened_literal() {
    Term made = ground_literal();
    if (choices_.once_in(2)) {
      for (Term& arg : made.args) {
        if (choices_.once_in(2)) arg = opened(arg);
      }
    }
    if (!choices_.once_in(4)) open_annotations(made);
    return made;
  }

  // Opens at most one annotation of each name: otherwise their order depends on variables' names.
  void open_annotations(Term& made) {
    std::string open;
    for (Term& annot : made.annots) {
      const bool is_structure = annot.kind == Term::Kind::literal && !annot.args.empty();
      if (choices_.once_in(3)) continue;
      if (is_structure && annot.name != open) {
        open = annot.name;
        annot.args[0] = opened(annot.args[0]);
      } else if (!is_structure && choices_.once_in(2)) {
        annot = opened(annot);
        break;
      }
    }
    std::stable_sort(made.annots.begin(), made.annots.end(), [](const Term& a, const Term& b) {
      return a.kind != Term::Kind::variable && b.kind == Term::Kind::variable;
    });
    // Jason sometimes omits the default source in an open set.
    const bool may_be_open = made.annots.empty() || test::has_source(made.annots);
    if (may_be_open && choices_.once_in(5)) made.rest = new_variable().name;
  }

  void drop_rest(Term& made) {
    if (made.rest.empty()) return;
    std::erase(named_, made.rest);
    made.rest.clear();
  }

  Term opened(const Term& term) {
    const bool has_parts = !term.args.empty();
    if (!has_parts || choices_.once_in(2)) {
      if (!known_.empty() && choices_.once_in(4)) return variable("B");
      if (!named_.empty() && choices_.once_in(6)) return variable(named_.front());
      return choices_.once_in(4) ? variable(fmt::format("_{}", ++unnamed_)) : new_variable();
    }
    Term made = term;
    made.args.front() = opened(made.args.front());
    if (made.kind == Term::Kind::list && choices_.once_in(2)) {
      made.args.resize(1);
      made.rest = new_variable().name;
    }
    return made;
  }

  Term new_variable() {
    named_.push_back(fmt::format("V{}", named_.size()));
    return variable(named_.back());
  }

  test::Choices choices_;
  std::size_t argument_kinds_ = 0;
  std::size_t annotation_kinds_ = 0;
  BeliefList beliefs_;
  std::string text_;
  std::vector<std::string> expected_;
  std::vector<std::string> heard_;  // events with a plan
  Bindings known_;                  // variables that have a value before the statement
  std::vector<std::string> named_;  // variables of the statement
  std::size_t unnamed_ = 0;
  std::size_t open_deletions_ = 0;
};

void compare(std::uint64_t first, std::size_t count, std::size_t initial_beliefs) {
  std::size_t open_deletions = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Script script(seed, initial_beliefs);
    open_deletions += script.open_deletions();
    ASSERT_EQ(test::printed_by(script.text()), script.expected()) << "seed " << seed << "\n"
                                                                  << script.text();
  }
  EXPECT_GT(open_deletions, count);  // otherwise patterns hardly ever match
}

TEST(BeliefStatements, AgreeWithAListOfAFewBeliefs) { compare(0, 300, 4); }

TEST(BeliefStatements, AgreeWithAListOfManyBeliefs) { compare(1000, 200, 40); }

}  // namespace
}  // namespace jaywalk
