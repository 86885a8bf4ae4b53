// .intend: goals in the stacks of intentions that are not suspended.
!start.
+!start
  <- !!other(1); .wait(20); if (.intend(other(X))) { .print("other ", X) }; if (.intend(start)) { .print("itself") };
     .suspend(other(_)); if (not .intend(other(_))) { .print("suspended") }; !failure.
+!other(_) <- .wait(1000).
+!failure <- .intend(none); .print("never").
-!failure[error(E)] <- .print(E).
// expect: other 1
// expect: itself
// expect: suspended
// expect: ia_failed
