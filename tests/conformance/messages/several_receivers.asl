// A list of names is a list of receivers.
// agent ann
!start.
+!start <- .send([bob, eve], tell, hello).
// agent bob
+hello[source(S)] <- .print(S).
// agent eve
+hello[source(S)] <- .print(S).
// expect [bob]: ann
// expect [eve]: ann
