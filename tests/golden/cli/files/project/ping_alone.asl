!start.

+!start <- .print("no environment needed").
