!start.

+!start <- .print("hello").
