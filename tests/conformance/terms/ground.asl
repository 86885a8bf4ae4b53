// A term is ground if no variable in it is free.
!start.
+!start <- .eval(A, .ground(f(1, [a]))); .eval(B, .ground(f(X))); X = 1; .eval(C, .ground(f(X))); .print(A, " ", B, " ", C).
// expect: true false true
