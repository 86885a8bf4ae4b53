// Numbers print as in Java.
!start.
+!start <- .print(10.0); .print(1 / 3); .print(12345678.5); .print(0.0001); .print(2 ** 53 + 1); .print(1.0e20); .print(0 * -1).
// expect: 10
// expect: 0.3333333333333333
// expect: 1.23456785E7
// expect: 1.0E-4
// expect: 9007199254740992
// expect: 1.0E20
// expect: 0
