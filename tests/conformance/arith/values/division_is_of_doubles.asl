// / never cuts.
!start.
+!start <- .print(7 / 2); .print(-1 / 4); .print(6 / 3); X = 1; .print(X / 3 * 3).
// expect: 3.5
// expect: -0.25
// expect: 2
// expect: 1
