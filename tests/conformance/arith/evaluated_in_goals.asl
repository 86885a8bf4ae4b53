// Arguments of goals and beliefs are evaluated.
!count(3).
+!count(0) <- .print("done").
+!count(N) : N > 0 <- .print(N); +seen(N * 10); !count(N - 1).
+seen(X) <- .print("seen ", X).
// expect: 3
// expect: seen 30
// expect: 2
// expect: seen 20
// expect: 1
// expect: seen 10
// expect: done
