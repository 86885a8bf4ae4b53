// ** is right associative, and signs bind tighter.
!start.
+!start <- .print(2 ** 3 ** 2); .print(-2 ** 2); .print(2 ** -1); .print(4 ** 0.5); .print(0 ** 0).
// expect: 512
// expect: 4
// expect: 0.5
// expect: 2
// expect: 1
