// A plan without a body does nothing.
!start.
+!start <- !nothing; .print("done").
+!nothing.
// expect: done
