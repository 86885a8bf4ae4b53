// An action that the environment refuses fails the plan.
// environment: board
!start.
+!start <- refuse(this); .print("never").
-!start[error(E), error_msg(M)] <- .print(E, ": ", M).
// expect: action_failed: refused
