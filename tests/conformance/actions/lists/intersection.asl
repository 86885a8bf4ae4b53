// .intersection: what both have, sorted, each once.
!start.
+!start <- .intersection([c, a, a, b], [b, c, d], R); .print(R); .intersection([a], [b], E); .print(E); .intersection([], [a], F); .print(F); !failure.
+!failure <- .intersection([a], 3, _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [b,c]
// expect: []
// expect: []
// expect: wrong_arguments
