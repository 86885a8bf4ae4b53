// Asked of a list of agents, the answers are a list.
// agent bob
price(2).
// agent cid
price(3).
// agent ann
!start.
+!start <- .send([bob, cid], askOne, price(_), L); .length(L, N); .print(N).
// expect [ann]: 2
