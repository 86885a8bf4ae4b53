// dg: after the plan the goal is tested; it failed if it does not hold.
!start.
+!start <- !open(door); .print("never").
-!start[error(E)] <- .print("failed: ", E).
{ begin dg(open(door)) }
+!open(door) <- .print("knock").
{ end }
// expect: knock
// expect: failed: test_goal_failed
