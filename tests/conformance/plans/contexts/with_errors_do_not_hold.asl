// What cannot be calculated in a context is no solution, and no failure.
!start.
+!start : .nth(9, [a], _) <- .print("never").
+!start : .length(12, _) <- .print("never").
+!start <- .print("the last").
// expect: the last
