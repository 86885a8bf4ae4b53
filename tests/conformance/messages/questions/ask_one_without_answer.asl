// Nobody knows: the answer is false.
// agent ann
!start.
+!start <- .send(bob, askOne, price(_), A); .print(A).
// agent bob
other(3).
// expect [ann]: false
