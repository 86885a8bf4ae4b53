// .range: up to and with the end, by a step, downwards by a negative one; a known number is tested.
!start.
+!start
  <- .findall(X, .range(X, 1, 4), L); .print(L); .findall(X, .range(X, 1, 8, 3), S); .print(S); .findall(X, .range(X, 3, 1, -1), D); .print(D);
     .findall(X, .range(X, 2, 1), E); .print(E); .findall(X, .range(X, 5, 5), O); .print(O); .range(3, 1, 4); .range(1, 1, 4); .range(4, 1, 4); !failure; !wrong.
+!failure <- .range(5, 1, 4); .print("never").
-!failure[error(E)] <- .print(E).
+!wrong <- .range(_, a, 4); .print("never").
-!wrong[error(E)] <- .print(E).
// expect: [1,2,3,4]
// expect: [1,4,7]
// expect: [3,2,1]
// expect: []
// expect: [5]
// expect: ia_failed
// expect: wrong_arguments
