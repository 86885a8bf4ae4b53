// math.pi, math.e, math.log: the natural logarithm, of 0 minus infinity, of a negative none.
!start.
+!start <- .print(math.pi, " ", math.e); .print(math.log(1), " ", math.log(math.e), " ", math.log(0), " ", math.log(-1)).
// expect: 3.141592653589793 2.718281828459045
// expect: 0 1 -Infinity NaN
