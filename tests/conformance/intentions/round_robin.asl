// One event and one formula in each cycle; intentions take turns.
!a. !b. !c.
+!a <- .print(a1); .print(a2).
+!b <- .print(b1); .print(b2).
+!c <- .print(c1); .print(c2).
// expect: a1
// expect: a2
// expect: b1
// expect: c1
// expect: b2
// expect: c2
