// A test of an expression fails without looking for plans.
!start.
+!start <- ?a & b; .print("never").
-!start[error(E)] <- .print(E).
+?a <- .print("never").
// expect: test_goal_failed
