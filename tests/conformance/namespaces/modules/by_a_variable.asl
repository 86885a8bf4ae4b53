// A variable as namespace stands for each that has such a belief.
m::p(1). n::p(2).
!start.
+!start <- .findall(X, N::p(X), L); .sort(L, S); .print(S); M = n; ?M::p(Y); .print(Y).
// expect: [1,2]
// expect: 2
