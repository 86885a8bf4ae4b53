// .shuffle keeps the elements and changes their order alone.
!start.
+!start
  <- .shuffle([c, a, b, a], L); .sort(L, S); .print(S); .shuffle([], E); .print(E); .shuffle([x], O); .print(O); !failure.
+!failure <- .shuffle(atom, _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [a,a,b,c]
// expect: []
// expect: [x]
// expect: wrong_arguments
