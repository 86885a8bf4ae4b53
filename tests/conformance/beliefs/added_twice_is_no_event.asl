// Adding what is believed already makes no event.
!start.
+!start <- +b(1); +b(1); .print("done").
+b(X) <- .print("event ", X).
// expect: event 1
// expect: done
