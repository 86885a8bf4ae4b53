// A tail has what is not named.
b[a, m, z(1)].
!start.
+!start : b[m | T] <- .print(T).
// expect: [a,source(self),z(1)]
