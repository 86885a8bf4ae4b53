// A belief with one variable in two places, asked with one variable in two places.
!go.
+!go <- +p([X], X); ?p([Z], Z); Z = 1; .print(Z); ?p([A], B); A = 2; .print(B).
// expect: 1
// expect: 2
