// The event of a deletion is handled before the intention goes on.
b(1).
!start.
+!start <- -b(1); .print("after").
-b(X)[source(S)] <- .print("deleted ", X, " of ", S).
// expect: deleted 1 of self
// expect: after
