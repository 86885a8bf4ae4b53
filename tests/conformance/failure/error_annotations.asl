// The failure event says what went wrong, and where.
!start.
+!start <- !g.
+!g <- ?missing(3).
-!g[error(E), code(C), code_line(L)] <- .print(E, " ", C, " ", L).
// expect: test_goal_failed missing(3) 4
