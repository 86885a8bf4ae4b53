// Like join.asl, with the last of three arguments bound in the inner query.
n(100).
two(X, Z) :- edge(X, _, Y) & edge(Z, _, X) & Y > Z.
!start.
+!start : n(N) <- !make(N); .count(two(_, _), C); .print(C).
+!make(0).
+!make(I) : I > 0 <- +edge(I, road, I+1); !make(I-1).
