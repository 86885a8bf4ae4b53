// A goal may fail and be tried again.
tries(0).
!start.
+!start <- !g; .print("done").
+!g <- ?tries(N); -+tries(N + 1); N >= 3; .print("at last").
-!g <- ?tries(N); .print("try ", N); !g.
// expect: try 1
// expect: try 2
// expect: try 3
// expect: at last
// expect: done
