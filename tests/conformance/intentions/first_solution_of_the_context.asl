// The context's first solution is taken, and not reconsidered.
b(1). b(2).
!start.
+!start : b(X) <- .print(X); X == 2; .print("never").
-!start <- .print("failed").
// expect: 1
// expect: failed
