// Usual precedence; ** is right associative; unary minus binds tightest.
!start.
+!start <- .print(1 + 2 * 3); .print((1 + 2) * 3); .print(10 - 4 - 3); .print(2 ** 3 ** 2); .print(-2 ** 2); .print(12 / 4 / 3).
// expect: 7
// expect: 9
// expect: 3
// expect: 512
// expect: 4
// expect: 1
