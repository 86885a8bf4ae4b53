// Plans are tried in the order of the program.
b(2).
!start.
+!start : b(1) <- .print("first").
+!start : b(2) <- .print("second").
+!start <- .print("third").
// expect: second
