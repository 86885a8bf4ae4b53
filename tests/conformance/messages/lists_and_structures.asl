// Contents of any shape arrive whole.
// agent ann
!start.
+!start <- .send(bob, tell, data([1, "two", three(4)[k]], ~no)).
// agent bob
+data(L, N) <- .print(L, N).
// expect [bob]: [1,"two",three(4)[k]]~no
