// A failure plan may post the goal again.
tries(0).
!start.
+!start <- !risky; .print("done").
+!risky : tries(N) & N < 3 <- -+tries(N + 1); .print("try ", N); .fail.
+!risky <- .print("works").
-!risky <- !risky.
// expect: try 0
// expect: try 1
// expect: try 2
// expect: works
// expect: done
