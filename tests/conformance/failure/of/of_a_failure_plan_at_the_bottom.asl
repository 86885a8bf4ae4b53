// A failure plan that fails at the bottom of its intention is looked for again; so is one in whose
// body a goal fails that has none.
n(0).
!start.
+!start <- !!bottom; .wait(100); -+n(0); !!inner; .wait(100); -+n(0); !!unknown; .wait(100); -+n(0); !!caller.
+!bottom <- .fail.
-!bottom : n(X) & X < 3 <- -+n(X + 1); .print("again ", X); .fail.
-!bottom <- .print("at last").
+!inner <- .fail.
-!inner : n(X) & X < 2 <- -+n(X + 1); .print("inner ", X); !below; .print("never").
-!inner <- .print("inner at last").
+!below <- .fail.
-!below <- .print("below fails, too"); .fail.
// Goals that have no plan at all.
-!unknown[error(E)] : n(X) & X < 2 <- -+n(X + 1); .print(E, " ", X); !no_such_goal.
-!unknown <- .print("unknown at last").
// The caller comes first where there is one.
+!caller <- !called.
+!called <- .fail.
-!called : n(X) & X < 5 <- -+n(X + 1); .print("called ", X); .fail.
-!caller <- .print("caller").
// expect: again 0
// expect: again 1
// expect: again 2
// expect: at last
// expect: inner 0
// expect: below fails, too
// expect: inner 1
// expect: below fails, too
// expect: inner at last
// expect: no_relevant 0
// expect: no_relevant 1
// expect: unknown at last
// expect: called 0
// expect: caller
