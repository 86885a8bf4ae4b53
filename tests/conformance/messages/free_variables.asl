// A told literal may have free variables.
// agent ann
!start.
+!start <- .send(bob, tell, likes(X, cake)).
// agent bob
+likes(_, What) : likes(anyone, What) <- .print(What).
// expect [bob]: cake
