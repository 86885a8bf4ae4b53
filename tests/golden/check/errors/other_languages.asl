# What somebody writes who knows other languages,
# and some of them well.
% Comments are one thing,
speed(3).  % the other
half(X, Y) :- Y = X % 2.
+!assign : speed(X) <- Y := X + 1; .print(Y).
+!plan := stay.
rule(X) := speed(X).
+!say <- .print(“hello”); .print(‘a’).
+!mean(X) : X ≤ 3 <- move(left)→ stay.
+!one_branch <- if (speed(3)) stay; move(left).
+!two_branches <- if (speed(3)) { stay } else stay.
+!repeat <- while speed(3) { stay }.
+!each <- for (speed(X)) move(left).
+!dollar <- .print($x).
+!sum <- .print(x + 1).
