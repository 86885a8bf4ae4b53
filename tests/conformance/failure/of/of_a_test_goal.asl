// -? is the failure of ?.
!start.
+!start <- ?t(1); .print("after").
+?t(X) <- .fail.
-?t(X) <- .print("t failed ", X).
// expect: t failed 1
// expect: after
