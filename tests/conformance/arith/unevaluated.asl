// An expression with a free variable waits until it is used again.
!start.
+!start <- Y = X + 1; .print(Y); X = 2; .print(Y).
// expect: (X+1)
// expect: 3
