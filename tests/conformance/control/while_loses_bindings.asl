// What a round binds is free again in the next, and after the loop.
n(0).
!start.
+!start <- while (n(X) & X < 2) { Y = X * 10; .print(Y); -+n(X + 1) }; .print(X, " ", Y).
// expect: 0
// expect: 10
// expect: X<no-value> Y<no-value>
