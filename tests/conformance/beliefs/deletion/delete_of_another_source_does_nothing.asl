// -b does not delete what only another agent said.
b(1)[source(bob)].
!start.
+!start <- -b(1); .count(b(_), N); .print(N).
-b(_) <- .print("never").
// expect: 1
