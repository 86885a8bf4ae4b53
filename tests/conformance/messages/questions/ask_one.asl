// askOne with a fourth argument waits for the answer.
// agent ann
!start.
+!start <- .send(bob, askOne, price(_), A); .print("answer"); price(P)[source(S)] = A; .print(P).
// agent bob
price(3).
// expect [ann]: answer
// expect [ann]: 3
