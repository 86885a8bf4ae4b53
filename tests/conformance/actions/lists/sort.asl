// .sort: numbers, strings, lists, literals; duplicates stay.
!start.
+!start
  <- .sort([c, 2, a, 2, "s", [z], f(1), -1, ~a, b(2)], L); .print(L); .sort([], E); .print(E); .sort([f(2), f(1, 0), f(1)], F); .print(F);
     !failure(atom); !other.
+!failure(X) <- .sort(X, _); .print("never").
-!failure(_)[error(E)] <- .print(E).
+!other <- .sort([b, a], [b, a]); .print("never").
-!other[error(E)] <- .print(E).
// expect: [-1,2,2,"s",[z],a,~a,b(2),c,f(1)]
// expect: []
// expect: [f(1),f(1,0),f(2)]
// expect: wrong_arguments
// expect: ia_failed
