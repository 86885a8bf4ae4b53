// askAll is answered by the list of all answers.
// agent ann
!start.
+!start <- .send(bob, askAll, price(_), L); .length(L, N); .print(N); .send(bob, askAll, none(_), M); .print(M).
// agent bob
price(1). price(2). price(3).
// expect [ann]: 3
// expect [ann]: []
