// A sub-plan that is relevant but not applicable does not hide the plans further out.
!start.
+!start <- !o; !deep(1).
+!o <- !i. { +!i : false <- .print("inner"). }
+!deep(X) <- !middle. { +!middle <- !i. { +!i : X > 1 <- .print("innermost"). } +!i : X > 0 <- .print("inner ", X). }
+!i <- .print("outer").
// expect: outer
// expect: inner 1
