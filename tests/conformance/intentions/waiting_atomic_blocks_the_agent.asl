// While an atomic intention waits, the whole agent does.
!a. !b.
@first[atomic] +!a <- .print(a1); .wait(100); .print(a2).
+!b <- .print(b1).
// expect: a1
// expect: a2
// expect: b1
