// .wait: for a time, an event, a formula; the end of the time is a failure unless it is asked for.
!start. !helper.
+!helper <- .wait(100); +p(1); .wait(100); +q(2).
+!start
  <- .wait({ +p(X) }); .print(X); .wait(q(Y)); .print(Y); .wait(q(2), 50); .print("at once"); .wait(none, 50, Elapsed);
     if (Elapsed >= 50) { .print("elapsed") }; .wait({ +none }, 20, _); .print("no event"); !failure.
+!failure <- .wait(none, 30); .print("never").
-!failure[error(E)] <- .print(E).
// expect: 1
// expect: 2
// expect: at once
// expect: elapsed
// expect: no event
// expect: wait_timeout
