// -+b makes an event of deletion and one of addition.
b(1).
!start.
+!start <- -+b(2); .print("done").
+b(2) <- .print("added").
-b(1) <- .print("deleted").
// expect: deleted
// expect: added
// expect: done
