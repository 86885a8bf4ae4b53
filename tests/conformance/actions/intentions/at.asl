// .at posts an event after a time and goes on at once.
!start.
+!start
  <- .at("now +100 ms", { +!later(1) }); .at("now", { +!later(0) }); .at("now +1 s", { +b(2) }); .print("at once"); .wait(2000); !failure.
+!later(X) <- .print("later ", X).
+b(X) <- .print("event ", X); if (not b(X)) { .print("not believed") }.
+!failure <- .at(now, 5); .print("never").
-!failure[error(E)] <- .print("refused").
// expect: at once
// expect: later 0
// expect: later 1
// expect: event 2
// expect: not believed
// expect: refused
