// When the plan for a failure is done, the caller goes on as if the goal had succeeded.
!start.
+!start <- !risky; .print("after").
+!risky <- .print("try"); .fail; .print("never").
-!risky <- .print("mend").
// expect: try
// expect: mend
// expect: after
