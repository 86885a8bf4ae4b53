// tellHow gives a plan, untellHow takes it away by its label.
// agent bob
!start.
+!start <- .wait({+ready}); !greet; .wait({+over}); !greet.
-!greet[error(E)] <- .print(E).
// agent ann
!teach.
+!teach
  <- .send(bob, tellHow, "@hi +!greet <- .print(\"hello\")."); .send(bob, tell, ready); .wait(50);
     .send(bob, untellHow, hi); .send(bob, tell, over).
// expect [bob]: hello
// expect [bob]: no_relevant
