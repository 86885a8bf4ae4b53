// When the plan for the deletion of a belief fails, the whole intention is lost; so is that of an
// addition if there are plans for the deletion.
!start.
+!start <- !!a; .wait(30); !!a2; .wait(20); !!a3; .wait(20); .print(end).
+!a <- +b; -b; .print(never).
-!a <- .print("a failed").
-b <- .fail.
+!a2 <- +c; .print(never).
-!a2 <- .print("a2 failed").
+c <- .fail.
+!a3 <- +b2; .print(never).
-!a3 <- .print("a3 failed").
+b2 <- !z.
+!z <- .fail.
-b2 <- .print("b2 deleted").
// expect: a2 failed
// expect: end
