// untell removes the sender's source alone.
// agent bob
b[source(self)].
!watch.
+!watch <- .wait({+told}); if (b[source(ann)]) { .print("told") }; .wait({+over}); if (b & not b[source(ann)]) { .print("own alone") }.
// agent ann
!start.
+!start <- .send(bob, tell, b); .send(bob, tell, told); .wait(50); .send(bob, untell, b); .send(bob, tell, over).
// expect [bob]: told
// expect [bob]: own alone
