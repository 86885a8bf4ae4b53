// An action that goes wrong in a context makes the plan not applicable.
!start.
+!start : .nth(7, [a], X) <- .print("never").
+!start <- .print("second").
// expect: second
