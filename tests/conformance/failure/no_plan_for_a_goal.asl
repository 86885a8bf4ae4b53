// A goal without a plan fails; its own failure plan may handle that.
!start.
+!start <- !g(1); .print("after").
-!g(X)[error(E)] <- .print(X, " ", E).
// expect: 1 no_relevant
// expect: after
