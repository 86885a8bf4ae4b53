// The annotations of a failure say which error it was, and what .fail added.
!a. !b. !c.
+!a <- .fail(why(bored)).
-!a[why(W)] <- .print(W).
+!b <- 1 > 2.
-!b[error(E), code(C)] <- .print(E, " of ", C).
+!c <- ?nothing(3).
-!c[error(E)] <- .print(E).
// expect: bored
// expect: constraint_failed of (1 > 2)
// expect: test_goal_failed
