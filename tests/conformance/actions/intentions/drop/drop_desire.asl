// .drop_desire: intentions and events with the goal.
!start.
+!start <- !!a(1); !!a(2); .drop_desire(a(2)); .wait(20); .drop_desire(a(1)); .drop_desire(none); .wait(200); .print("end").
+!a(X) <- .print("began ", X); .wait(100); .print("never").
// expect: began 1
// expect: end
