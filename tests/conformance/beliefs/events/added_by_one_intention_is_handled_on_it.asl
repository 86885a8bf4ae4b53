// +b waits until its event was handled; the plan's intention is the one that added it.
!start.
+!start <- .print("before"); +b(1); .print("after").
+b(X) <- .print("sees ", X); .print("still before").
// expect: before
// expect: sees 1
// expect: still before
// expect: after
