// An agent's own plan for kqml_received comes before the standard ones.
// agent ann
!start.
+!start <- .send(bob, tell, secret(1)); .send(bob, tell, open(2)).
// agent bob
+!kqml_received(S, tell, secret(X), _) <- .print("ignored from ", S).
+open(X) <- .print(X).
// expect [bob]: ignored from ann
// expect [bob]: 2
