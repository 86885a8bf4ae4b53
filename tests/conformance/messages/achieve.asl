// achieve gives the receiver a goal.
// agent ann
!start.
+!start <- .send(bob, achieve, go(north)).
// agent bob
+!go(X)[source(S)] <- .print(X, " for ", S).
// expect [bob]: north for ann
