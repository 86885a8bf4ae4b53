// .drop_future_intention: those in whose plan the goal is still to come.
!start.
+!start <- !!a; !!b; .wait(20); .drop_future_intention(later); .drop_future_intention(none); .wait(200); .print("end").
+!a <- .wait(100); !later.
+!b <- .wait(100); .print("b goes on").
+!later <- .print("never").
// expect: b goes on
// expect: end
