// .reverse: lists and strings.
!start.
+!start
  <- .reverse([a, [b, c], 1], R); .print(R); .reverse([], E); .print(E); .reverse("abc", S); .print(S); .reverse("", T); .length(T, N); .print(N);
     !failure.
+!failure <- .reverse([a, b], [a, b]); .print("never").
-!failure[error(E)] <- .print(E).
// expect: [1,[b,c],a]
// expect: []
// expect: cba
// expect: 0
// expect: ia_failed
