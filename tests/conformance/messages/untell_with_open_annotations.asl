// untell with a variable in an annotation removes the sender's source and the matched annotation.
// agent ann
!start.
+!start
  <- .send(bob, tell, [price(3)[t(1)], price(4)[t(2)], price(5)[t(3)]]); .send(bob, tell, ready);
     .wait(100);
     .send(bob, untell, price(3)[t(_)]); .send(bob, untell, price(4)[t(1)]); .send(bob, untell, price(5)[t(_)]);
     .send(bob, untell, ready[T]).
// agent bob
price(3).
ready[u].
-price(X)[t(T), source(S)] <- .print("untold ", X, " ", T, " by ", S).
-ready[source(S)] <- .print("not ready by ", S).
!show.
+!show <- .wait(300); .findall(b(X, A), price(X)[|A], L); .print(L); .findall(A, ready[|A], M); .print(M).
// expect [bob]: untold 5 3 by ann
// expect [bob]: not ready by ann
// expect [bob]: [b(4,[source(ann),t(2)]),b(3,[source(self)])]
// expect [bob]: []
