// Formulas as terms have their parentheses.
!start.
+!start
  <- .print(f(a & b | c)); .print(f(not a)); .print(f(X > 1 & not (X == 2))); .print(f(X \== Y)); .print(f(a =.. L)).
// expect: f(((a & b) | c))
// expect: f(not (a))
// expect: f(((X > 1) & not ((X == 2))))
// expect: f((X \== Y))
// expect: f((a =.. L))
