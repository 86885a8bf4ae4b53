// `--` and its like are operators of a body only where a formula begins; behind an operand they are two signs.
!go.
+!go
  <- X = 3;
     Y = X--1;
     .print(Y, " ", X++1, " ", X-+1, " ", 2--2, " ", (X)--X);
     ++b(X--1); --b(_); -+b(X++2);
     ?b(Z); .print(Z).
// expect: 4 4 2 4 6
// expect: 5
