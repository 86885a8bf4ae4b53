// A time limit makes .wait fail, or says how long it took.
!start.
+!start <- .wait(never, 20, T); if (T >= 20) { .print("enough") }; .wait(never, 20); .print("never").
-!start[error(E)] <- .print(E).
// expect: enough
// expect: wait_timeout
