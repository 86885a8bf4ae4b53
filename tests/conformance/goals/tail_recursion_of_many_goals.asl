// Any number of goals in a loop needs no more memory than one.
// limit cycles 5000000
// limit heap 4000000
!count(100000).
+!count(0) <- .print("done").
+!count(N) <- !count(N - 1).
// expect: done
