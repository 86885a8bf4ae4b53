// The answer has to unify with the fourth argument.
// agent bob
price(2).
// agent ann
!start.
+!start <- .send(bob, askOne, price(_), price(3)); .print("never").
-!start[error(E)] <- .print(E).
// expect [ann]: ask_failed
