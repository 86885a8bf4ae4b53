// While an atomic plan runs, no other intention does.
!a. !b.
@one[atomic] +!a <- .print("a1"); !sub; .print("a3").
+!sub <- .print("a2").
+!b <- .print("b1").
// expect: a1
// expect: a2
// expect: a3
// expect: b1
