// X = f(X) is no failure, but the term cannot be used.
!start.
+!start <- X = f(X); !use(X); .print("never").
-!start <- .print("given up").
+!use(_) <- .print("never").
// expect: given up
