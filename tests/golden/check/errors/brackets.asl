list([1, 2).
+!go : (at(X, Y) <- move(left).
+!go <- if (at(X, Y)) { move(left); stay.
+!go <- move(left)).
term(f(g(1), h(2).
text("not closed).
fine.
