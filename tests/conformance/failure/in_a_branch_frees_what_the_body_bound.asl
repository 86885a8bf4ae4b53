// What the failed body has bound in its goal is free for -!g, in a branch of a fork as elsewhere.
!s.
+!s <- !c(X); .print(back, " ", X).

+!c(A) <- A = 1; (.print(a)) |&| (.fail).
-!c(A) : not .ground(A) <- A = 2.
-!c(A)                  <- .print(still, " ", A).
// expect: a
// expect: back 2
