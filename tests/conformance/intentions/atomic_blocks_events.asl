// While an atomic intention runs no other event is selected.
!a.
@first[atomic] +!a <- !!b; +c; .print(a1); .print(a2).
+!b <- .print(b1).
+c <- .print(c1).
// expect: c1
// expect: a1
// expect: a2
// expect: b1
