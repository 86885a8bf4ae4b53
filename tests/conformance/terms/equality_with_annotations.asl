// == compares annotations, too.
!start.
+!start <- .eval(A, p[a, b] == p[b, a]); .eval(B, p[a] == p); .eval(C, p == p); .print(A, " ", B, " ", C).
// expect: true false true
