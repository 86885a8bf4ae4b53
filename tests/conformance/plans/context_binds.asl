// The context's variables are known in the body.
limit(10). b(3).
!check.
+!check : limit(L) & b(X) & X < L & D = L - X <- .print(D).
// expect: 7
