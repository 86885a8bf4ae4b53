// .at posts an event after a time and goes on at once.
!start.
+!start
  <- .at("now +100 ms", { +!later(1) }); .at("now +0", { +!later(0) }); .at("now +1 s", { +b(2) }); .print("at once"); .wait(2000); !failure.
+!later(X) <- .print("later ", X).
+b(X) <- .print("event ", X); if (not b(X)) { .print("not believed") }.
+!failure <- !refused("now +1 s", 5); !refused("now", { +!later(2) }); !refused("now + 3s", { +!later(3) }); !refused("tomorrow", { +!later(4) }).
+!refused(When, What) <- .at(When, What); .print("never").
-!refused(When, _)[error(E)] <- .print(When, " ", E).
// expect: at once
// expect: later 0
// expect: later 1
// expect: event 2
// expect: not believed
// expect: now +1 s wrong_arguments
// expect: now internal_action
// expect: now + 3s unknown
// expect: tomorrow internal_action
