// .rename_apart: the same, by other names.
!start.
+!start
  <- .rename_apart(f(X, Y, X), R); R = f(A, B, C); A = 1; .print(C, X); .rename_apart(p(a), K); .print(K); !failure.
+!failure <- .rename_apart(p(a), p(b)); .print("never").
-!failure[error(E)] <- .print(E).
// expect: 1X<no-value>
// expect: p(a)
// expect: ia_failed
