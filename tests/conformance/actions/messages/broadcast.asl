// .broadcast: to all but itself.
// agent ann
!start.
+!start <- .broadcast(tell, p(1)); .broadcast(achieve, g).
+p(_) <- .print("never").
// agent bob
+p(X)[source(S)] <- .print(X, S).
+!g[source(S)] <- .print(g, S).
// agent cid
+p(X) <- .print(X).
+!g <- .print(g).
// expect [bob]: 1ann
// expect [bob]: gann
// expect [cid]: 1
// expect [cid]: g
