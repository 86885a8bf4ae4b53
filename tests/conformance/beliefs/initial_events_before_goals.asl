// The events of the initial beliefs come before the initial goals.
!start.
b(1).
+b(X) <- .print("belief").
+!start <- .print("goal").
// expect: belief
// expect: goal
