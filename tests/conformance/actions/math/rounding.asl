// math.abs, ceil, floor, round, sqrt: halves go up, the root of a negative is not a number.
!start.
+!start
  <- .print(math.abs(-2.5), " ", math.abs(0), " ", math.abs(3)); .print(math.ceil(1.2), " ", math.ceil(-1.2), " ", math.ceil(2));
     .print(math.floor(1.8), " ", math.floor(-1.2), " ", math.floor(2)); .print(math.round(2.5), " ", math.round(-2.5), " ", math.round(1.4));
     .print(math.sqrt(16), " ", math.sqrt(0), " ", math.sqrt(-1)); .print(math.abs(X)); Y = 2; .print(math.sqrt(Y + 2)).
// expect: 2.5 0 3
// expect: 2 -1 2
// expect: 1 -2 2
// expect: 3 -2 1
// expect: 4 0 NaN
// expect: math.abs(X)
// expect: 2
