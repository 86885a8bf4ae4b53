// ?p(X) binds X for the rest of the body, by the first that is believed.
p(1). p(2).
!start.
+!start <- ?p(X); ?p(Y) ; .print(X, Y); ?(p(Z) & Z > 1); .print(Z).
// expect: 11
// expect: 2
