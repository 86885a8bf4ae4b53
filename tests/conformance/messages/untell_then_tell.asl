// What is told last counts.
// agent ann
!start.
+!start <- .send(bob, tell, price(3)); .send(bob, untell, price(3)); .send(bob, tell, price(3)).
// agent bob
+price(X) <- .print("told ", X).
-price(X) : price(X) <- .print("still believed").
-price(X) <- .print("untold ", X).
// expect [bob]: told 3
// expect [bob]: untold 3
// expect [bob]: told 3
