// One event is handled and one formula executed in each cycle; intentions take turns.
!a. !b. !c.
+!a <- .print("a1"); .print("a2"); .print("a3").
+!b <- .print("b1"); .print("b2").
+!c <- .print("c1").
// expect: a1
// expect: a2
// expect: b1
// expect: a3
// expect: c1
// expect: b2
