// What the condition of an if binds is known afterwards.
b(1).
!start.
+!start <- if (b(X)) { Y = X + 1 } else { Y = 0 }; .print(X, Y).
// expect: 12
