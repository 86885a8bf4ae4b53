!start.

+!start <- .print("hello"

+!go : true <- stay.
+!stop : x( <- stay.
