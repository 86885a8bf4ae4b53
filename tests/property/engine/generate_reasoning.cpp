// SPDX-License-Identifier: Apache-2.0
#include "tests/property/engine/generate_reasoning.h"

#include <span>
#include <string_view>

namespace jaywalk::test {
namespace {

/// X and Y are bound to numbers wherever a formula stands; Z, W and V may be open.
class ReasoningWriter {
 public:
  ReasoningWriter(Choices& choices, Senses senses)
      : choices_(choices), perceives_(senses == Senses::some) {}

  std::string write() {
    beliefs();
    rules();
    if (perceives_) rules_of_percepts();
    for (int goal = 0; goal < kGoals; ++goal) plans_for(goal);
    event_plans();
    for (int i = 0; i < 3; ++i) {
      add("!"), goal_name(),
          add("(" + std::to_string(1 + choices_.below(5)) + ", " + small() + ", _).\n");
    }
    return std::move(text_);
  }

 private:
  static constexpr int kGoals = 4;

  void add(std::string_view text) { text_ += text; }
  void add_some(std::span<const std::string_view> texts) {
    for (const std::string_view text : texts) {
      if (choices_.once_in(2)) add(text);
    }
  }
  std::string small() { return std::to_string(choices_.below(6)); }
  void goal_name() { add("g" + std::to_string(choices_.below(kGoals))); }

  void beliefs() {
    const std::size_t count = choices_.below(14);
    for (std::size_t i = 0; i < count; ++i) {
      add(choices_.one_of({"n(", "n(", "at(1,", "at(2,", "at(a,"})), add(small()), add(")");
      if (choices_.once_in(4)) {
        add(choices_.one_of({"[k]", "[k,m(2)]", "[source(a1)]", "[m(1)]"}));
      }
      add(".\n");
    }
    add(choices_.one_of({"", "s(\"one\"). s(b).\n", "l([1,2,3]). l([]).\n", "at(f(1),2).\n"}));
    if (choices_.once_in(12)) add("at(Q,4).\n");
    if (choices_.once_in(8)) {
      for (int i = 0; i < 20; ++i) add("n(" + std::to_string(i) + "). ");
    }
  }

  void rules() {
    static constexpr std::string_view kRules[] = {
        "r(X) :- n(X) & X > 2.\n",
        "r(X) :- at(_,X).\n",
        "d(X,D) :- at(X,Y) & D = math.abs(X-Y)+1.\n",
        "d(1,0).\nd(X,2) :- X > 3.\n",
        "d(X,Y) :- at(X,Y) & not n(Y).\n",
        "r(X) :- n(X)[k].\n",
        "len([],0).\nlen([_|T],N) :- len(T,M) & N = M+1.\n",
        "app([],L,L).\napp([H|T],L,[H|R]) :- app(T,L,R).\n",
        "best(X) :- n(X) & not (n(Y) & Y > X).\n",
        "d(X,X).\n",
        "r(X) :- n(X) | at(X,_).\n",
        "up(X,X).\nup(X,Y) :- n(Z) & Z > X & up(Z,Y).\n",
        "n(7) :- at(1,_).\n",
        "at(X,9)[k] :- n(X) & X < 2.\n",
        "pair(f(X,Y),Y,X).\n"};
    add_some(kRules);
  }

  // The percepts are c(1), c(3), w(1,2), w(2,3) and w(4,1), which are constant, and tick(T).
  void rules_of_percepts() {
    static constexpr std::string_view kRules[] = {
        "k(X,Y) :- w(X,Y) & c(Z) & X < Z.\n",
        "k(X,2) :- c(X).\n",
        "k(X,Y) :- limit(X) & k2(X,Y).\n",
        "k2(X,Y) :- c(Y) & X > Y.\n",
        "m(S) :- w(X,Y) & S = X+Y.\n",
        "m(S) :- k(S,_) & limit(L) & L > 2.\n",
        "m(X) :- c(X) & X > 1 & w(X,_).\n",
        "e :- c(X) & w(_,X).\n",
        "f(X,T) :- c(X) & tick(T).\n",
        "h(X) :- c(X) & X / (X-3) < 5.\n",
        "up(X,Z) :- w(X,Y) & up(Y,Z).\nup(X,Y) :- w(X,Y).\n"};
    add_some(kRules);
    add(choices_.one_of({"limit(3). limit(1).\n", "limit(1).\n", "limit(a). limit(2).\n", ""}));
    if (choices_.once_in(8)) add("c(2).\n");
    if (choices_.once_in(4)) add("+c(X) <- .print(sees, X).\n");
    if (choices_.once_in(4)) add("+w(X,Y)[source(S)] : k(Z,W) <- .print(sees, X, Y, S, Z, W).\n");
    if (choices_.once_in(3)) add("-c(X) <- .print(misses, X).\n");
    if (choices_.once_in(3)) add("+tick(T) <- !g1(T,T,_).\n");
  }

  void query_of_percepts() {
    add(choices_.one_of({"k(Z,W)",
                         "k(Z,W)",
                         "k(X,Z)",
                         "k(Z,Z)",
                         "k(Z,X)",
                         "m(Z)",
                         "m(Z)",
                         "m(X)",
                         "e",
                         "f(Z,W)",
                         "h(Z)",
                         "up(Z,W)",
                         "up(X,Z)",
                         "c(Z)",
                         "w(Z,V)",
                         "c(Z)[source(V)]",
                         "k(X-1,Z)",
                         "w(X,Z)",
                         ".findall(Q,m(Q),W)",
                         ".count(k(_,_),Z)",
                         "not k(Z,W)",
                         "limit(Z)"}));
  }

  void change_of_percepts() {
    add(choices_.one_of({"+c(X)", "-c(Z)", "-c(3)[source(percept)]", "-+limit(Y)", "+limit(X)",
                         "-limit(Z)", ".abolish(w(_,_))", "-w(2,3)[source(percept)]", "+w(X,Y)",
                         "+c(1)[k]", ".perceive", "+w(1,2)", "-c(X)[source(percept)]"}));
  }

  void number(int depth) {
    if (depth > 0 && choices_.once_in(3)) {
      add("("), number(depth - 1);
      add(choices_.one_of({"+", "-", "*", "+", "-", "/", " mod ", " div ", "**"}));
      number(depth - 1), add(")");
    } else if (choices_.once_in(16)) {
      add(choices_.one_of({"math.abs(X-4)", "math.max(X,Y)", ".count(n(_))", "-X", "Z"}));
    } else {
      add(choices_.one_of({"X", "Y", "X", "Y", "1", "2", "3", "0", "2.5"}));
    }
  }

  void term() {
    if (choices_.once_in(3)) {
      add(choices_.one_of({"a", "f(X)", "f(Z,1)", "[1,X|W]", "[X,Y]", "\"t\"", "_", "[]", "f(_,Z)",
                           "n(X)[k]", "Z", "W", "f(X+1)", "~a"}));
    } else {
      number(1);
    }
  }

  void test() {
    if (choices_.once_in(3)) {
      add(choices_.one_of({"Z", "W", "V"})), add(" = "), term();
    } else {
      choices_.once_in(5) ? term() : number(1);
      add(choices_.one_of({" < ", " <= ", " > ", " >= ", " == ", " \\== ", " = "}));
      choices_.once_in(5) ? term() : number(1);
    }
  }

  void query() {
    if (perceives_ && choices_.once_in(2)) {
      query_of_percepts();
      return;
    }
    add(choices_.one_of({"n(X)",
                         "n(Z)",
                         "n(Z)[k]",
                         "n(Z)[m(V)]",
                         "at(X,Z)",
                         "at(Z,Y)",
                         "at(Z,W)",
                         "at(Z,Z)",
                         "r(Z)",
                         "r(X)",
                         "d(X,Z)",
                         "d(Z,W)",
                         "d(X,Y)",
                         "len([1,X],Z)",
                         "app(Z,W,[1,X])",
                         "best(Z)",
                         "up(X,Z)",
                         "s(V)",
                         "l([Z|W])",
                         "l(V)",
                         "pair(f(1,Z),W,V)",
                         "pair(V,X,Y)",
                         "nothing(Z)",
                         "at(f(Z),W)",
                         "n(X+1)",
                         "d(X-1,Z)",
                         "V",
                         "at(_,_)",
                         "n(Z)[source(S)]",
                         "seen(Z)"}));
  }

  void formula(int depth) {
    switch (choices_.below(depth > 0 ? 12 : 6)) {
      case 0:
      case 1:
        test();
        return;
      case 2:
      case 3:
      case 4:
        query();
        return;
      case 5:
        add(choices_.one_of({"true", ".member(Z,[1,X,Y])", ".range(Z,X,3)", ".length([X,Y],Z)",
                             ".concat([X],[Y],Z)", ".findall(Q,n(Q),W)", "false",
                             ".intend(g1(_,_,_))", ".sort([Y,X],W)", ".ground(Z)"}));
        return;
      case 6:
        add("not ("), formula(depth - 1), add(")");
        return;
      case 7:
        add("("), formula(depth - 1), add(" | "), formula(depth - 1), add(")");
        return;
      default:
        formula(depth - 1), add(" & "), formula(depth - 1);
        return;
    }
  }

  void plans_for(int goal) {
    const std::string name = "g" + std::to_string(goal);
    const std::size_t count = 1 + choices_.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      if (choices_.once_in(6)) {
        add("@p" + std::to_string(++labels_));
        add(choices_.one_of({"", "[atomic]", "[all_unifs]"})), add(" ");
      }
      add("+!" + name + "(X, Y, ");
      add(choices_.one_of(
          {"Z", "Z", "_", "f(Z,V)", "[Z|W]", "X", "2", "a", "[a|W]", "[]", "[Z|Z]"}));
      add(") : X > 0 & Y < 9");
      if (!choices_.once_in(3)) add(" & "), formula(2);
      add(" <- "), body(2, 5), add(".\n");
    }
    add("+!" + name + "(" + choices_.one_of({"X", "0", "X"}).data() + ", Y, ");
    add(choices_.one_of({"Y", "0", "Z", "done"})), add(")");
    add(choices_.one_of({"", "", " : Y >= 0", " <- .print(Y, Z)"})), add(".\n");
    if (choices_.once_in(2)) return;
    add("-!" + name + "(X, Y, Z)");
    add(choices_.one_of({"", "[error(E)]", "[error_msg(M)]"})), add(" <- .print(failed, X, Z)");
    add(choices_.one_of({"", "; Z = 1", "; +seen(X)"})), add(".\n");
  }

  void event_plans() {
    if (choices_.once_in(2)) add("+seen(X) : Y = X+1 & n(Z) <- .print(seen, X, Z).\n");
    if (choices_.once_in(2)) add("-seen(X) <- .print(unseen, X).\n");
    if (choices_.once_in(3)) add("+n(X) : Y = 2 <- "), body(1, 2), add(".\n");
    if (choices_.once_in(3)) add("+at(X,Z)[source(A)] <- .print(at, X, Z, A).\n");
    if (choices_.once_in(3)) add("+?seen(Z) : Y = 1 & X = 2 <- Z = 3; "), body(0, 2), add(".\n");
    if (choices_.once_in(3)) add("+got(X)[source(A)] : Y = 0 <- .print(got, X, A).\n");
  }

  void body(int depth, std::size_t most) {
    const std::size_t count = 1 + choices_.below(most);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) add("; ");
      step(depth);
    }
  }

  void goal() {
    add(choices_.once_in(9) ? "!!" : "!"), goal_name(), add("(X-1, ");
    choices_.once_in(3) ? number(1) : add("Y");
    add(", "),
        add(choices_.one_of(
            {"Z", "W", "V", "_", "Z", "f(Z,W)", "X", "a", "a[k]", "[X|W]", "[a[k]|V]", "[Z,W]"})),
        add(")");
  }

  void step(int depth) {
    if (perceives_ && choices_.once_in(8)) {
      change_of_percepts();
      return;
    }
    switch (choices_.below(depth > 0 ? 16 : 11)) {
      case 0:
      case 1:
      case 2:
        goal();
        return;
      case 3:
        add("?"), formula(1);
        return;
      case 4:
      case 5:
        add(choices_.one_of({"+", "-", "-+", "+", "-+", "++", "+>"}));
        add(choices_.one_of({"seen(X)", "n(X)", "n(Y)[k]", "seen(X+1)", "at(X,Y)", "seen(_)",
                             "n(Z)", "flag", "seen(f(X,W))", "at(Z,X)[m(2)]"}));
        return;
      case 6:
        test();
        return;
      case 7:
      case 8:
        add(".print("), term(), add(", Z, W, V)");
        return;
      case 9:
        add(choices_.one_of(
            {".send(a1, tell, got(X))", ".send(a0, achieve, g0(X-1,Y,_))", ".random(V)", ".fail",
             ".wait(1)", ".findall(Z,n(Z),W)", ".abolish(seen(_))", ".send(a0, askOne, n(_), V)",
             ".succeed_goal(g2(_,_,_))", ".nth(0,[X,Y],Z)", ".add_plan({+!g9 <- .print(nine)})"}));
        return;
      case 10:
        test();
        return;
      case 11:
      case 12:
        add("if ("), formula(1), add(") { "), body(depth - 1, 3), add(" }");
        if (choices_.once_in(2)) add(" else { "), body(depth - 1, 2), add(" }");
        return;
      case 13:
        add("for ("), formula(1), add(") { "), body(depth - 1, 2), add(" }");
        return;
      case 14:
        add("while (seen(Z)) { -seen(Z); "), body(depth - 1, 2), add(" }");
        return;
      default:
        add("{ "), body(depth - 1, 2), add(choices_.one_of({" } |&| { ", " } ||| { "}));
        body(depth - 1, 2), add(" }");
        return;
    }
  }

  Choices& choices_;
  bool perceives_;
  std::string text_;
  int labels_ = 0;
};

}  // namespace

std::string random_reasoning(Choices& choices, Senses senses) {
  return ReasoningWriter(choices, senses).write();
}

}  // namespace jaywalk::test
