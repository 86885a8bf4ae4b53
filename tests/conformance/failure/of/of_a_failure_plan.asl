// A failure plan that fails is its caller's failure.
!start.
+!start <- !a; .print("never").
-!start[error(E)] <- .print("start failed: ", E).
+!a <- .fail.
-!a <- .print("repairing"); 1 > 2.
// expect: repairing
// expect: start failed: constraint_failed
