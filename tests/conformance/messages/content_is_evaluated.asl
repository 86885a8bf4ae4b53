// The content is applied when the message is sent.
// agent ann
!start.
+!start <- X = 2; .send(bob, tell, v(X * 3, [X])).
// agent bob
+v(A, B) <- .print(A, B).
// expect [bob]: 6[2]
