// A performative that nobody knows can be handled by a plan.
// agent ann
!start.
+!start <- .send(bob, gossip, rain).
// agent bob
+!kqml_received(S, gossip, What, _) <- .print(S, " says ", What).
// expect [bob]: ann says rain
