// .nth counts from 0; an unbound index goes through the elements; beyond the end is an error.
!start.
+!start
  <- .nth(0, [a, b, c], X); .nth(2, [a, b, c], Y); .print(X, Y); .nth(1, "xyz", C); .print(C);
     .findall(I, .nth(I, [a, b, a], a), L); .print(L); .findall(f(I, E), .nth(I, [p, q], E), M); .print(M);
     !failure(3); !failure(-1); !other.
+!failure(I) <- .nth(I, [a, b, c], _); .print("never").
-!failure(I)[error(E)] <- .print(I, " ", E).
+!other <- .nth(0, [a], b); .print("never").
-!other[error(E)] <- .print(E).
// expect: ac
// expect: y
// expect: [0,2]
// expect: [f(0,p),f(1,q)]
// expect: 3 internal_action
// expect: -1 internal_action
// expect: ia_failed
