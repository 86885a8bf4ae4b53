// Rules may recurse very deeply.
sum(0, 0).
sum(N, S) :- N > 0 & sum(N - 1, T) & S = T + N.
!start.
+!start <- ?sum(20000, S); .print(S).
// expect: 200010000
