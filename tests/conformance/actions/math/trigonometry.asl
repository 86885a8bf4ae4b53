// Angles are radians; beyond the domain a result is not a number.
!start.
+!start
  <- .print(math.sin(0), " ", math.cos(0), " ", math.tan(0)); .print(math.asin(0), " ", math.acos(1), " ", math.atan(0));
     .print(math.acos(2), " ", math.asin(-2)); .print(math.round(math.sin(math.pi / 2) * 1000), " ", math.round(math.atan(1) * 4000), " ", math.round(math.tan(math.pi / 4) * 10)).
// expect: 0 1 0
// expect: 0 0 0
// expect: NaN NaN
// expect: 1000 3142 10
