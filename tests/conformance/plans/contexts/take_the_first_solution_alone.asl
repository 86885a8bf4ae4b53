// What fails later in the body does not bring another solution of the context.
p(1). p(2).
!start.
+!start : p(X) <- .print(X); X > 1; .print("never").
-!start <- .print("failed").
// expect: 1
// expect: failed
