// What a goal leaves open in its results is not shared with its caller's variables.
!start.
+!start <- !wrap(A, B); A = 1; .eval(R, B == q(1)); .print(R); q(C) = B; .print("still open").
+!wrap(X, Y) <- Y = q(X).
// expect: false
// expect: still open
