// A question with a time limit goes on with `timeout`.
// agent bob
+?price(X) <- .wait(1000); X = 2.
// agent ann
!start.
+!start <- .send(bob, askOne, price(_), A, 100); .print(A).
// expect [ann]: timeout
