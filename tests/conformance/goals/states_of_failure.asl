// A goal that fails without a plan for that is finished, with those below it; dropped goals are, too.
// expect: inner failed ia_failed
// expect: inner finished
// expect: outer failed
// expect: outer finished
// expect: g failed constraint_failed
// expect: g executing has_failure_plan
// expect: g achieved
// expect: g finished
// expect: d dropped
// expect: d finished
// expect log: no failure event was generated
!main.
+!main <- !!outer; .wait(100); !!g; .wait(100); !!d; .wait(100); .drop_intention(d).
+!outer <- !inner.
+!inner <- .fail.
+!g <- 1 > 2.
-!g.
+!d <- .wait(5000).
^!X[state(S)[reason("")]] : .member(S,[failed,achieved,finished,dropped]) & X \== main
  <- .print(X," ",S).
^!X[state(S)[reason(R)]] : R == ia_failed | R == constraint_failed | R == has_failure_plan
  <- .print(X," ",S," ",R).
