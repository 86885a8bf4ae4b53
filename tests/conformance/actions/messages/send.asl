// .send: to an agent, a list, itself; a question with an answer; an unknown agent is an error.
// agent ann
!start.
+!start
  <- .send(bob, tell, hello(1)); .send([bob, ann], tell, all); .send(bob, askOne, price(_), A); price(P) = A; .print("price ", P);
     .send(bob, askOne, nothing(_), N); .print(N); .send(bob, askOne, slow, S, 50); .print(S); !failure; !answer.
+all[source(S)] <- .print("all from ", S).
+!failure <- .send(nobody, tell, p); .print("never").
-!failure[error(E)] <- .print(E).
+!answer <- .send(bob, askOne, price(_), price(9)); .print("never").
-!answer[error(E)] <- .print(E).
// agent bob
price(5).
+hello(X)[source(S)] <- .print("hello ", X, " ", S).
+all <- .print("all").
+?slow <- .wait(1000).
// expect [ann]: all from self
// expect [ann]: price 5
// expect [ann]: false
// expect [ann]: timeout
// expect [ann]: receiver_not_found
// expect [ann]: ask_failed
// expect [bob]: hello 1 ann
// expect [bob]: all
