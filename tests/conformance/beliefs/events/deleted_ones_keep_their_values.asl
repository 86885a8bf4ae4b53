// The event of a deletion has what was deleted.
b(1). b(2).
!start.
+!start <- -b(2); -b(_); ?not b(_); .print("none left").
-b(X) <- .print("lost ", X).
// expect: lost 2
// expect: lost 1
// expect: none left
