// A plan's annotations must be among those of the goal.
!start.
+!start <- !g[fast, loud]; !g[slow]; !g.
+!g[fast] <- .print("fast").
+!g[slow] <- .print("slow").
+!g <- .print("plain").
// expect: fast
// expect: slow
// expect: plain
