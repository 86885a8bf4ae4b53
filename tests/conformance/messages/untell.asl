// untell takes the sender's source away.
// agent ann
!start.
+!start <- .send(bob, tell, price(3)); .send(bob, untell, price(3)).
// agent bob
+price(X) <- .print("told ", X).
-price(X)[source(S)] <- .print("untold ", X, " by ", S).
// expect [bob]: told 3
// expect [bob]: untold 3 by ann
