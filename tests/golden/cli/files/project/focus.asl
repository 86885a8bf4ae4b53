!go.
+!go <- .wait(10); +b; .print("after +b").
+b <- .print("plan for b, first"); .print("plan for b, then").
