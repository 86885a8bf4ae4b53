// Rules take lists apart.
sum([], 0).
sum([H | T], S) :- sum(T, R) & S = H + R.
last([X], X).
last([_ | T], X) :- last(T, X).
!start.
+!start : sum([1, 2, 3, 4], S) & last([a, b, c], L) <- .print(S, " ", L).
// expect: 10 c
