// .wait suspends one intention; time is virtual.
!a. !b.
+!a <- .print(a1); .wait(2000); .print(a2).
+!b <- .print(b1); .wait(1000); .print(b2).
// expect: a1
// expect: b1
// expect: b2
// expect: a2
