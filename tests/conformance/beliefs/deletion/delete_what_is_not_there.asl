// Deleting what is not believed succeeds and makes no event.
!start.
+!start <- -b(1); .print("fine").
-b(_) <- .print("never").
// expect: fine
