// Whole numbers have no point; others are the shortest that read back, with an exponent from 1e7 on
// and below 1e-3.
!start.
+!start
  <- .print(3.0); .print(-0.0); .print(0.1); .print(1/3); .print(12345678.5); .print(0.0001);
     .print(1e20); .print(2**53); .print(100 / 8).
// expect: 3
// expect: 0
// expect: 0.1
// expect: 0.3333333333333333
// expect: 1.23456785E7
// expect: 1.0E-4
// expect: 1.0E20
// expect: 9007199254740992
// expect: 12.5
