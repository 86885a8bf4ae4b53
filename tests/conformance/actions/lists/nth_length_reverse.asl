// The usual list functions.
!start.
+!start <- L = [a, b, c]; .nth(1, L, X); .length(L, N); .reverse(L, R); .print(X, N, R).
// expect: b3[c,b,a]
