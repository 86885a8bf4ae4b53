// The plan for a belief runs on top of the goal that added it, and fails it.
!start.
+!start <- !a; .print("after").
+!a <- +b; .print("never").
+b <- .fail.
-!a <- .print("a failed").
// expect: a failed
// expect: after
