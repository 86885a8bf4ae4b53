// Without a plan for its own failure, a goal fails its caller.
!start.
+!start <- !outer; .print("after outer").
+!outer <- !inner; .print("never").
+!inner <- .fail.
-!outer <- .print("outer is mended").
// expect: outer is mended
// expect: after outer
