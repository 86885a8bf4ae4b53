// Arithmetic in a head is evaluated when the body has been solved.
double(X, X * 2).
succ(X, Y + 1) :- Y = X.
!start.
+!start <- ?double(4, R); ?succ(4, S); .print(R, " ", S).
// expect: 8 5
