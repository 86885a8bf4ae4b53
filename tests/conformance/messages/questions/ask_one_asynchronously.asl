// Without a fourth argument the answer becomes a belief.
// agent ann
!start.
+!start <- .send(bob, askOne, price(_)); .print("goes on").
+price(X)[source(S)] <- .print(X, " from ", S).
// agent bob
price(3).
// expect [ann]: goes on
// expect [ann]: 3 from bob
