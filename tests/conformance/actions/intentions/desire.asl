// .desire: what is intended, suspended, or still an event.
!start.
+!start
  <- !!other(1); if (.desire(other(X))) { .print("an event ", X) }; .wait(20); if (.desire(other(_))) { .print("intended") };
     .suspend(other(_)); if (.desire(other(_))) { .print("suspended") }; !failure.
+!other(_) <- .wait(1000).
+!failure <- .desire(none); .print("never").
-!failure[error(E)] <- .print(E).
// expect: an event 1
// expect: intended
// expect: suspended
// expect: ia_failed
