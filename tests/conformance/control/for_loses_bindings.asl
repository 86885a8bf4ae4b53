// Bindings of a for are lost after each round.
!start.
+!start <- for (.member(X, [1, 2])) { Y = X + 1; .print(Y) }; .print(X, " ", Y).
// expect: 2
// expect: 3
// expect: X<no-value> Y<no-value>
