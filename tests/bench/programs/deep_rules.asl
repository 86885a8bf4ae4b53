// Rules that call each other a million deep.
n(1000000).
depth(0, 0).
depth(N, D) :- N > 0 & depth(N-1, E) & D = E + 1.
!start.
+!start : n(N) & depth(N, D) <- .print(D).
