// .drop_intention: all that have the goal; without argument itself; none is no failure.
!start.
+!start <- !!a; !!b; !!self; .wait(50); .drop_intention(a); .drop_intention(none); .wait(200); .print("end").
+!a <- .wait(100); .print("never").
+!b <- .wait(100); .print("b goes on").
+!self <- .print("before"); .drop_intention; .print("never").
// expect: before
// expect: b goes on
// expect: end
