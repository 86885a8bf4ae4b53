// .eval tells whether a formula holds.
b(3).
!start.
+!start
  <- .eval(R, b(X) & X > 2); .print(R); .eval(Q, b(9)); .print(Q); .eval(T, true); .print(T);
     .eval(O, b(9) | not b(8)); .print(O); !failure.
+!failure <- .eval(true, b(9)); .print("never").
-!failure[error(E)] <- .print(E).
// expect: true
// expect: false
// expect: true
// expect: true
// expect: ia_failed
