// A told belief has its sender as source and makes an event.
// agent ann
!start.
+!start <- .send(bob, tell, price(3)).
// agent bob
+price(X)[source(S)] <- .print(X, " from ", S).
// expect [bob]: 3 from ann
