// Conditions that say nothing.
!go.

+!go : at(X, Y) & X + 1 == "2" & Y < 10        <- stay.
+!go : at(X, Y) & X == X & not at(X, Y)        <- move(Y).
+!go : at(X, Y) & not (false) & (1 > 2 | X > Y) <- X = X + 1; if (not true) { stay }.
+!go : false                                   <- stay.
+!go                                           <- while (true) { stay }.
