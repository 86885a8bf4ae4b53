// askOne is answered by rules, too.
// agent bob
price(tea, 2). price(cake, 3).
sum(S) :- price(tea, A) & price(cake, B) & S = A + B.
// agent ann
!start.
+!start <- .send(bob, askOne, sum(_), A); .print(A); .send(bob, askOne, sum(X), sum(Y)); .print(Y).
// expect [ann]: sum(5)[source(bob)]
// expect [ann]: 5
