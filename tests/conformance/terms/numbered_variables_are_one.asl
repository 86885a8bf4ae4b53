// _1 is one variable, however it goes on.
!start.
+!start <- f(_1, _1a) = f(X, Y); X = 3; .print(Y).
// expect: 3
