!go.
+!go <- .print(;
