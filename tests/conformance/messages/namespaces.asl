// What messages say may be of any namespace.
// agent ann
!start.
+!start
  <- .send(bob, tell, shop::price(3)); .send(bob, tell, [shop::open, shop::price(4)]);
     .send(bob, askOne, shop::price(3), shop::A); .print(shop::A);
     .send(bob, askAll, shop::price(_), L); .print(L);
     .send(bob, askOne, shop::discount(X), shop::D); .print(shop::D);
     .send(bob, askOne, shop::nothing, N); .print(N);
     .send(bob, achieve, [shop::close]); .send(bob, untell, shop::price(3)).
// agent bob
+shop::price(X)[source(S)] <- .print("price ", X, " from ", S).
-shop::price(X) <- .print("no longer ", X).
+?shop::discount(X) <- X = 1.
+!shop::close[source(S)] <- .print("closed by ", S).
// expect [ann]: shop::price(3)[source(bob)[source(ann)]]
// expect [ann]: [shop::price(4)[source(bob)[source(ann)]],shop::price(3)[source(bob)[source(ann)]]]
// expect [ann]: shop::discount(1)[source(bob)]
// expect [ann]: false
// expect [bob]: price 3 from ann
// expect [bob]: price 4 from ann
// expect [bob]: no longer 3
// expect [bob]: closed by ann
