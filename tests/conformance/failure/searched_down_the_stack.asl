// Without a failure plan of its own, a goal's failure is its caller's.
!start.
+!start <- !a; .print("after a").
+!a <- !b; .print("never").
+!b <- !c; .print("never").
+!c <- .fail.
-!a <- .print("a failed").
// expect: a failed
// expect: after a
