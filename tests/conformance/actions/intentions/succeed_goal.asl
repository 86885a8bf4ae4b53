// .succeed_goal: the goal counts as achieved, what posted it goes on; none is no failure.
!start.
+!start <- !!caller; .wait(50); .succeed_goal(g(_)); .succeed_goal(none); .wait(50); .print("end").
+!caller <- !g(1); .print("after g").
+!g(_) <- .wait({ +none }); .print("never").
// expect: after g
// expect: end
