// What cannot be calculated stays an expression, within parentheses.
!start.
+!start
  <- .print(f(X + 1)); .print(f(-X)); .print(f(X mod 2)); .print(f(X div 2)); .print(f(X ** 2 * 3));
     .print(f(X / 2 - 1)).
// expect: f((X+1))
// expect: f((-X))
// expect: f((X mod 2))
// expect: f((X div 2))
// expect: f(((X**2)*3))
// expect: f(((X/2)-1))
