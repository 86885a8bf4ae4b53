// .min: by the order of terms; of a query's solutions; of nothing it fails.
p(3, c). p(9, a). p(2, b).
!start.
+!start
  <- .min([3, -9, 2], M); .print(M); .min([a, "s", [x]], T); .print(T); .min([f(1, z), f(1, a)], f(A, B)); .print(A, B);
     .min(X, p(_, X), Q); .print(Q); !failure; !none.
+!failure <- .min([], _); .print("never").
-!failure[error(E)] <- .print(E).
+!none <- .min(X, p(X, z), _); .print("never").
-!none[error(E)] <- .print(E).
// expect: -9
// expect: s
// expect: 1a
// expect: a
// expect: ia_failed
// expect: ia_failed
