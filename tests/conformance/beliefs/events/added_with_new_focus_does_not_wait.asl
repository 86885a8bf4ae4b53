// ++b: the event is another intention's; both take turns.
!start.
+!start <- .print("before"); ++b(1); .print("at once"); .print("later").
+b(X) <- .print("sees ", X).
// expect: before
// expect: at once
// expect: sees 1
// expect: later
