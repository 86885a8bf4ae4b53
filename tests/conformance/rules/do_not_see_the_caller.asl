// A variable of a rule has nothing to do with the caller's of the same name.
p(Y) :- X = 2 & Y = X.
!start.
+!start <- X = 1; ?p(Y); .print(X, Y).
// expect: 12
