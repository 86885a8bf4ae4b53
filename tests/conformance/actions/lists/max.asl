// .max: by the order of terms; of a query's solutions; of nothing it fails.
p(3, c). p(9, a). p(2, b).
!start.
+!start
  <- .max([3, 9, 2], M); .print(M); .max([a, "s", 5, [x]], T); .print(T); .max([f(1, z), f(2, a)], f(A, B)); .print(A, B);
     .max(X, p(X, _), Q); .print(Q); .max(f(X, Y), p(X, Y), R); .print(R); !failure; !none; !wrong.
+!failure <- .max([], _); .print("never").
-!failure[error(E)] <- .print(E).
+!none <- .max(X, p(X, z), _); .print("never").
-!none[error(E)] <- .print(E).
+!wrong <- .max([1, 2], 1); .print("never").
-!wrong[error(E)] <- .print(E).
// expect: 9
// expect: a
// expect: 2a
// expect: 9
// expect: f(9,a)
// expect: ia_failed
// expect: ia_failed
// expect: ia_failed
