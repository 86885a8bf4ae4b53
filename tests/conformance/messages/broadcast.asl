// .broadcast sends to all others.
// agent ann
!start.
+!start <- .broadcast(tell, hello).
+hello <- .print("never").
// agent bob
+hello[source(S)] <- .print(S).
// agent eve
+hello[source(S)] <- .print(S).
// expect [bob]: ann
// expect [eve]: ann
