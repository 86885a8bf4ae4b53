// .union: sorted, each once.
!start.
+!start <- .union([c, a, a], [b, c], R); .print(R); .union([], [], E); .print(E); .union([2, "s"], [], S); .print(S); !failure.
+!failure <- .union(a, [b], _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [a,b,c]
// expect: []
// expect: [2,"s"]
// expect: wrong_arguments
