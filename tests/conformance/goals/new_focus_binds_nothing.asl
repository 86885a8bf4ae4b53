// Values do not come back from !!.
!start.
+!start <- !!give(X); .print("sent"); .wait(1); .print(X).
+!give(1) <- .print("given").
// expect: sent
// expect: given
// expect: X<no-value>
