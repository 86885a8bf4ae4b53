// Who waits for a time leaves the others their turns; times are in order.
!a. !b. !c.
+!a <- .wait(30); .print("a").
+!b <- .wait(10); .print("b").
+!c <- .wait(20); .print("c").
// expect: b
// expect: c
// expect: a
