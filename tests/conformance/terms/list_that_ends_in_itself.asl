// A list that ends in itself can be printed, but has no length.
!start.
+!start <- L = [a|L]; .print(L); .length(L, N); .print(N).
-!start[error(E)] <- .print(E).
// expect: ...[a|L]/L
// expect: limit
