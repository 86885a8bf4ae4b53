// A goal that is ended by .fail_goal is not intended any more when its failure is handled.
!start.
+!g <- .print(g); .wait(1000).
-!g : .intend(g) <- .print(still).
-!g <- .print(gone).
+!w <- !g; .print(after).
+!start <- !!w; .wait(20); .fail_goal(g); .wait(50).
// expect: g
// expect: gone
// expect: after
