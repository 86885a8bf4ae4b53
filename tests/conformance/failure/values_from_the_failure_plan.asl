// A failure plan may bind what the goal was to bind.
!start.
+!start <- !find(X); .print(X).
+!find(X) <- .fail.
-!find(X) <- X = nothing.
// expect: nothing
