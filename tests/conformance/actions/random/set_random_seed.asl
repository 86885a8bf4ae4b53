// .set_random_seed: the same seed, the same numbers.
!start.
+!start
  <- .set_random_seed(5); .random(A); .random(B); .set_random_seed(5); .random(C); .random(D);
     if (A == C & B == D & not A == B) { .print("repeated") }; .set_random_seed(10); .random(E); if (not E == A) { .print("another") }; !failure.
+!failure <- .set_random_seed(a); .print("never").
-!failure[error(E)] <- .print(E).
// expect: repeated
// expect: another
// expect: unknown
