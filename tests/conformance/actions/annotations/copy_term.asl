// .copy_term: variables of its own, shared ones stay shared.
!start.
+!start
  <- .copy_term(f(X, Y, X, 1), C); C = f(A, B, D, E); A = 2; .print(D, E, X); .copy_term(a, K); .print(K); !failure.
+!failure <- .copy_term(f(1), f(2)); .print("never").
-!failure[error(E)] <- .print(E).
// expect: 21X<no-value>
// expect: a
// expect: ia_failed
