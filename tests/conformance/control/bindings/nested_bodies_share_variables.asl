// Blocks within blocks see the same variables.
!start.
+!start <- X = 1; if (true) { Y = X + 1; if (Y > 1) { Z = Y + 1 } }; .print(X, " ", Y, " ", Z).
// expect: 1 2 3
