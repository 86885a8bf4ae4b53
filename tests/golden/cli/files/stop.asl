!start.

+!start <- .print("so long"); .stopMAS.
