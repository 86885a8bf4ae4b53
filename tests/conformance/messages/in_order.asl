// Messages arrive in the order in which they are sent, one in each cycle.
// agent ann
!start.
+!start <- .send(bob, tell, n(1)); .send(bob, tell, n(2)); .send(bob, tell, n(3)).
// agent bob
+n(X) <- .print(X).
// expect [bob]: 1
// expect [bob]: 2
// expect [bob]: 3
