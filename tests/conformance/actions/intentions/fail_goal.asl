// .fail_goal: the goal fails, its failure plan runs; none is no failure.
!start.
+!start <- !!caller; .wait(50); .fail_goal(g(_)); .fail_goal(none); .wait(50); .print("end").
+!caller <- !g(1); .print("after g").
+!g(_) <- .wait({ +none }); .print("never").
-!g(X) <- .print("failed ", X).
// expect: failed 1
// expect: after g
// expect: end
