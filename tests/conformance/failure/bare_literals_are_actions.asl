// A literal without operator is an action, even if it is believed.
b(1).
!start.
+!start <- b(1); .print("never").
-!start[error(E)] <- .print(E).
// expect: action_failed
