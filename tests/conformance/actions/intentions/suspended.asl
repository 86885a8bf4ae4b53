// .suspended: why a goal waits; fails if it does not.
!start.
+!start
  <- !!a; !!b; .wait(20); .suspended(b, R); .print(R); if (.suspended(a, wait(_)[time(T)])) { .print(T) }; !failure.
+!a <- .wait(1000).
+!b <- .suspend.
+!failure <- .suspended(none, _); .print("never").
-!failure[error(E)] <- .print(E).
// expect: suspend_ia
// expect: 1000
// expect: ia_failed
