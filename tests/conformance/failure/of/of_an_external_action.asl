// Without an environment every external action fails.
!start.
+!start <- go(north); .print("never").
-!start[error(E)] <- .print(E).
// expect: action_failed
