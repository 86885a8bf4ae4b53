// A function that is a query has arguments of its own: those of the query around it stay.
{ register_function("my.f", 1, "f") }
f(X, Y) :- sum(X, 10, Y).
sum(A, B, C) :- C = A + B.
q(1, 12, 3, 14).
r(1, 12, 3, 14) :- true.
!go.
+!go
  <- if (q(1, my.f(2), 3, my.f(4))) { .print(fact) };
     if (r(1, my.f(2), 3, my.f(4))) { .print(rule) }.
// expect: fact
// expect: rule
