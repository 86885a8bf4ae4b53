// .difference: what the first has alone, sorted, each once.
!start.
+!start <- .difference([c, a, a, b], [b], R); .print(R); .difference([a], [a], E); .print(E); .difference([b, a], [], F); .print(F); !failure.
+!failure <- .difference([a], "a", _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [a,c]
// expect: []
// expect: [a,b]
// expect: wrong_arguments
