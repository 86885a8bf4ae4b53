// What failed before is not kept when a failure plan at the bottom is tried again.
// limit heap 4000000
// limit cycles 2000000
n(0).
!g.
+!g <- .fail.
-!g : n(X) & X < 200000 <- -+n(X + 1); .fail.
-!g : n(X) <- .print("done after ", X).
// expect: done after 200000
