// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent_tests/unit_test_goals.h"

namespace jaywalk {

std::string_view assertion_goals() {
  return R"asl(
jaywalk_test::results(0).

// Where the goal that is being handled was posted.
jaywalk_test::caller(Line, File) :-
    .intention(_, _, [im(Label, _, _, _) | _], current) &
    _[code_line(Line), code_src(File)] = Label.
jaywalk_test::caller(0, "") :- not .intention(_, _, _, current).

// A term as one would write it.
jaywalk_test::text(Term, Text) :- .string(Term) & .concat("\"", Term, "\"", Text).
jaywalk_test::text(Term, Text) :- not .string(Term) & .term2string(Term, Text).

// Lists are compared as sets.
jaywalk_test::same(X, Y) :- not .list(X) & not .list(Y) & X == Y.
jaywalk_test::same(X, Y) :- .list(X) & .list(Y) & not jaywalk_test::lacks(X, Y) &
                            not jaywalk_test::lacks(Y, X).
jaywalk_test::lacks(X, Y) :- .member(E, X) & not .member(E, Y).
jaywalk_test::collection(X) :- .type(X, list) | .type(X, set).
jaywalk_test::numbers(L) :- not (.member(N, L) & not .number(N)).

+!jaywalk_test::passed(Assertion, Line, File)
    <- ?jaywalk_test::results(N);
       -+jaywalk_test::results(N + 1);
       +jaywalk_test::result(N, Assertion, passed, Line, File, "", "").

// Expected and Actual are lists of what is put together to a text.
+!jaywalk_test::failed(Assertion, Line, File, Expected, Actual)
    <- ?jaywalk_test::results(N);
       -+jaywalk_test::results(N + 1);
       !jaywalk_test::join(Expected, "", ExpectedText);
       !jaywalk_test::join(Actual, "", ActualText);
       +jaywalk_test::result(N, Assertion, failed, Line, File, ExpectedText, ActualText).

+!jaywalk_test::join([], Text, Text).
+!jaywalk_test::join([term(T) | Rest], Before, Text) : jaywalk_test::text(T, Part)
    <- .concat(Before, Part, Next);
       !jaywalk_test::join(Rest, Next, Text).
+!jaywalk_test::join([Part | Rest], Before, Text)
    <- .concat(Before, Part, Next);
       !jaywalk_test::join(Rest, Next, Text).

+!jaywalk_test::judge(Condition, Assertion, Line, File, Expected, Actual)
    <- if (Condition) {
         !jaywalk_test::passed(Assertion, Line, File)
       } else {
         !jaywalk_test::failed(Assertion, Line, File, Expected, Actual)
       }.

@[atomic] +!assert_equals(X, Y) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(true & jaywalk_test::same(X, Y), assert_equals, L, F, [term(X)], [term(Y)]).

@[atomic] +!assert_equals(X, Y, T) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(jaywalk_test::numbers([X, Y, T]) & Y >= X - T & Y <= X + T,
                            assert_equals, L, F, [term(X), " +/- ", term(T)], [term(Y)]).

@[atomic] +!assert_not_equals(X, Y) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(not jaywalk_test::same(X, Y), assert_not_equals, L, F,
                            ["anything but ", term(X)], [term(Y)]).

@[atomic] +!assert_true(X) : jaywalk_test::caller(L, F)
    <- if (X) {
         !jaywalk_test::passed(assert_true, L, F)
       } else {
         !jaywalk_test::failed(assert_true, L, F, [term(X), " to be true"], [])
       }.

@[atomic] +!assert_false(X) : jaywalk_test::caller(L, F)
    <- if (X) {
         !jaywalk_test::failed(assert_false, L, F, [term(X), " to be false"], [])
       } else {
         !jaywalk_test::passed(assert_false, L, F)
       }.

@[atomic] +!assert_contains(X, Y) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(jaywalk_test::collection(X) & .member(Y, X), assert_contains, L, F,
                            ["a list or set with ", term(Y)], [term(X)]).

@[atomic] +!assert_not_contains(X, Y) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(jaywalk_test::collection(X) & not .member(Y, X), assert_not_contains,
                            L, F, ["a list or set without ", term(Y)], [term(X)]).

@[atomic] +!assert_greater_than(X, Y) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(jaywalk_test::numbers([X, Y]) & X > Y, assert_greater_than, L, F,
                            ["a number greater than ", term(Y)], [term(X)]).

@[atomic] +!assert_greater_than_equals(X, Y) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(jaywalk_test::numbers([X, Y]) & X >= Y, assert_greater_than_equals,
                            L, F, ["a number from ", term(Y)], [term(X)]).

@[atomic] +!assert_between(X, Low, High) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::judge(jaywalk_test::numbers([X, Low, High]) & X >= Low & X <= High,
                            assert_between, L, F,
                            ["a number from ", term(Low), " to ", term(High)], [term(X)]).

@[atomic] +!force_pass : jaywalk_test::caller(L, F)
    <- !jaywalk_test::passed(force_pass, L, F).

@[atomic] +!force_failure(Message) : jaywalk_test::caller(L, F)
    <- !jaywalk_test::failed(force_failure, L, F, [Message], []).

@[atomic] +!check_performance(Goal, N, Mean)
    <- .nano_time(Begin);
       for (.range(_, 1, N)) { !Goal };
       .nano_time(End);
       Mean = (End - Begin) / N.

// The tests are run from outside.
+!execute_test_plans.
+!create_default_fail_plan.

// Mock agents inform their owner when they have nothing to do.
+!create_mock_agent(Name) : .my_name(Me)
    <- .create_agent(Name, "mock_agent.asl");
       .send(Name, tell, mock_owner(Me)).
+!wait_idle(Name)
    <- .wait(not sleeping(Name), 300, _);
       .wait(sleeping(Name)).
)asl";
}

std::string_view mock_agent() {
  return R"asl(
+jag_sleeping : .my_name(Me) & mock_owner(Owner) <- .send(Owner, tell, sleeping(Me)).
+jag_awaking  : .my_name(Me) & mock_owner(Owner) <- .send(Owner, untell, sleeping(Me)).
)asl";
}

}  // namespace jaywalk
