// The annotations on the left must be among those on the right.
!start.
+!start <- .eval(A, p[a] = p[a, b]); .eval(B, p[a, b] = p[a]); .print(A, " ", B).
// expect: true false
