// Goals may nest deeply.
// limit cycles 200000
!down(20000).
+!down(0) <- .print("bottom").
+!down(N) <- !down(N - 1); +passed.
-!down(_) <- .print("never").
// expect: bottom
