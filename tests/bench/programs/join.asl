// A two-way join over n facts, the first argument of the inner query bound.
n(100).
two(X, Z) :- edge(X, Y) & edge(Y, Z).
!start.
+!start : n(N) <- !make(N); .count(two(_, _), C); .print(C).
+!make(0).
+!make(I) : I > 0 <- +edge(I, I+1); !make(I-1).
