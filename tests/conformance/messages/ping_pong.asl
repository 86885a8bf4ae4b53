// Two agents in conversation.
// agent ann
!start.
+!start <- .send(bob, achieve, ping(3)).
+!pong(N) <- .print("pong ", N); .send(bob, achieve, ping(N - 1)).
// agent bob
+!ping(0) <- .print("enough").
+!ping(N)[source(S)] <- .print("ping ", N); .send(S, achieve, pong(N)).
// expect [ann]: pong 3
// expect [ann]: pong 2
// expect [ann]: pong 1
// expect [bob]: ping 3
// expect [bob]: ping 2
// expect [bob]: ping 1
// expect [bob]: enough
