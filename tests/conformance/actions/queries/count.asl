// .count: an action and a function; it fails if the number is another.
c(1). c(2). c(3).
!start.
+!start
  <- .count(c(_), N); .print(N); .count(c(X) & X > 1, M); .print(M); .count(none, Z); .print(Z);
     K = .count(c(_)) + 1; .print(K); .count(c(_), 3); !failure.
+!failure <- .count(c(_), 4); .print("never").
-!failure[error(E)] <- .print(E).
// expect: 3
// expect: 2
// expect: 0
// expect: 4
// expect: ia_failed
