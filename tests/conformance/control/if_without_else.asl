// An if whose condition does not hold does nothing.
!start.
+!start <- if (b(_)) { .print("never") }; .print("after").
// expect: after
