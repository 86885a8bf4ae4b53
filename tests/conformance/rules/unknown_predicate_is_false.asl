// A literal that nobody believes is false, not an error.
!start.
+!start : not nothing(_) <- .print("fine").
// expect: fine
