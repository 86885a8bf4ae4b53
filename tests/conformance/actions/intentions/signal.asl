// .signal makes an event; nothing is believed.
!start.
+!start <- .signal({ +b(1) }); .wait(50); if (not b(_)) { .print("not believed") }; .signal({ +none }); .print("nobody cares").
+b(X)[source(S)] <- .print("event ", X, " ", S).
// expect: event 1 self
// expect: not believed
// expect: nobody cares
