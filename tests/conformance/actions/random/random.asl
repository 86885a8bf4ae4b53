// .random: from 0 up to 1; an element of a list; a number of answers.
!start.
+!start
  <- .random(X); if (X >= 0 & X < 1) { .print("in range") }; .findall(Y, .random(Y, 4), L); .length(L, N); .print(N);
     .random([a], E); .print(E); .random([b, b], Z); .print(Z); .findall(W, .random([c], W, 3), M); .print(M); !failure.
+!failure <- .random([a], b); .print("never").
-!failure[error(E)] <- .print("failed").
// expect: in range
// expect: 4
// expect: a
// expect: b
// expect: [c,c,c]
// expect: failed
