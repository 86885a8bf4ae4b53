// .setof: sorted, each once.
c(2, x). c(1, y). c(2, z). c("s", a).
!start.
+!start
  <- .setof(X, c(X, _), L); .print(L); .setof(X, none(X), E); .print(E); !failure.
+!failure <- .setof(X, c(X, _), [2, 1, "s"]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [1,2,"s"]
// expect: []
// expect: ia_failed
